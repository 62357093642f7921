#pragma once

#include "core/sculpt/dab_context.h"

namespace core
{
/// The plan of a dab, cut into sub-steps (paper, section 3.3): none of them moves a vertex farther than d_move. Where
/// surfaces cannot meet, one transaction does several sub-steps. Counts in ticks, eighths of a sub-step: one that fails
/// can be halved.
class StepPlan
{
public:
    /// Cuts the displacements that are planned for the region. Until then the plan has no sub-steps.
    void cut(const DabContext& context);
    bool isCut() const { return m_steps > 0; }
    /// Forgets the sub-steps: the plan was rolled back with the first of them.
    void discard() { m_steps = 0; }

    bool isDone() const { return isCut() && m_ticksLeft == 0; }
    /// Whether the next transaction does all that is left.
    bool isLast() const { return m_ticks >= m_ticksLeft; }
    /// Whether there are more sub-steps than a dab may do.
    bool isTooLong() const;
    /// Returns the share of the plan that the next transaction does.
    double part() const { return m_ticks / (ticksPerStep * m_steps); }
    /// Returns the sub-steps that the next transaction counts for.
    unsigned substeps() const { return std::max(m_ticks / ticksPerStep, 1u); }
    /// The transaction is committed: the next one may do twice as much.
    void advance();

    // --- after a transaction that failed -----------------------------------------------------------------------------
    /// Halves a transaction of several sub-steps. False if it was one, or a part of one.
    bool halveTransaction();
    void halveStep() { m_ticks = std::max(m_ticks / 2, 1u); }
    /// From now on a transaction does one sub-step at most.
    void takeSingleSteps();
    /// Counts a retry of this sub-step. False if it, or the dab, has had too many.
    bool mayRetry() { return ++m_retries <= maxRetriesPerStep && ++m_totalRetries <= maxRetriesPerDab; }
    unsigned retries() const { return m_retries; } ///< retries of this sub-step

private:
    static constexpr unsigned ticksPerStep = 8;
    static constexpr unsigned maxRetriesPerStep = 6,
                              maxRetriesPerDab = 12; ///< then the fallback step limits the motion

    double m_steps = 0;
    unsigned m_maxTicks = ticksPerStep; ///< ticks of a transaction at most
    unsigned m_ticks = ticksPerStep;    ///< ticks of the next transaction
    unsigned m_ticksLeft = 0;
    unsigned m_retries = 0;
    unsigned m_totalRetries = 0;
};
} // namespace core
