#pragma once

#include "core/sculpt/dab_steps.h"

namespace core
{
/// A sub-step of last resort, used if a direct sub-step did not verify and all retries failed. It first only moves the
/// vertices, with limits where they would touch something. Then it does each remeshing operation as its own verified
/// transaction; operations that fail are skipped.
class FallbackStep
{
public:
    explicit FallbackStep(DabSteps& steps) : m_steps(steps) {}

    /// Does the next transaction of the plan. Returns whether anything moved.
    bool apply(DabContext& context, StepPlan& plan);

private:
    bool moveWithinLimits(DabContext& context, double part);
    bool tightenAndMove(DabContext& context, double part);
    bool optimiseAtOnce(DabContext& context);

    DabSteps& m_steps;
    SlotSet m_frozen; ///< vertices near operations that did not verify; optimiseAtOnce() does not change them
};
} // namespace core
