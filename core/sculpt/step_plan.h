#pragma once

#include "core/sculpt/dab_context.h"

namespace core
{
/// The plan of a dab, cut into sub-steps (paper, section 3.3). No sub-step moves a vertex farther than d_move. Where
/// surfaces cannot meet, one transaction does several sub-steps. Progress is counted in ticks, eighths of a sub-step,
/// so that a sub-step that fails can be halved.
class StepPlan
{
public:
    /// Cuts the displacements planned for the region into sub-steps. A plan that is not cut has no sub-steps.
    void cut(const DabContext& context);
    bool isCut() const { return m_steps > 0; }
    /// Returns to the state before cut(), because the transaction that made the plan was rolled back.
    void discard() { m_steps = 0; }

    bool isDone() const { return isCut() && m_ticksLeft == 0; }
    /// Returns whether the next transaction completes the plan.
    bool isLast() const { return m_ticks >= m_ticksLeft; }
    /// Returns whether the plan has more sub-steps than a dab may do.
    bool isTooLong() const;
    /// Returns the share of the plan that the next transaction does.
    double part() const { return m_ticks / (ticksPerStep * m_steps); }
    /// Returns the number of sub-steps that the next transaction does; at least 1.
    unsigned substeps() const { return std::max(m_ticks / ticksPerStep, 1u); }
    /// Advances past a committed transaction. The next one may do twice as many sub-steps.
    void advance();
    /// Extends a plan that is done by up to this share of it, because motion limits have kept vertices back: by one
    /// sub-step at most, and by a quarter of the plan at most in all. Returns false if nothing was added.
    bool extend(double share);

    // --- after a transaction that failed -----------------------------------------------------------------------------
    /// Halves the next transaction, to no less than one sub-step. Returns false if it does no more than one already.
    bool halveTransaction();
    void halveStep() { m_ticks = std::max(m_ticks / 2, 1u); }
    /// Limits all further transactions to one sub-step.
    void takeSingleSteps();
    /// Counts a retry of this sub-step. Returns false if this sub-step or this dab has used up its retries.
    bool mayRetry() { return ++m_retries <= maxRetriesPerStep && ++m_totalRetries <= maxRetriesPerDab; }
    unsigned retries() const { return m_retries; }

private:
    static constexpr unsigned ticksPerStep = 8;
    static constexpr unsigned maxRetriesPerStep = 6,
                              maxRetriesPerDab = 12; ///< beyond these, the fallback step does the sub-step
    static constexpr double maxExtension = 0.25;     ///< share of the plan

    double m_steps = 0;
    unsigned m_maxTicks = ticksPerStep; ///< largest number of ticks in a transaction
    unsigned m_ticks = ticksPerStep;    ///< ticks in the next transaction
    unsigned m_ticksLeft = 0;
    unsigned m_retries = 0;
    unsigned m_totalRetries = 0;
    unsigned m_addedTicks = 0;
};
} // namespace core
