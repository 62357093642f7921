#pragma once

#include "core/sculpt/dab_steps.h"

namespace core
{
/// A sub-step of last resort, where a direct one did not verify and could not be made easier: first the motion alone,
/// limited where it would touch something, then each remeshing operation, verified by itself. What cannot be done is
/// left undone.
class FallbackStep
{
public:
    explicit FallbackStep(DabSteps& steps) : m_steps(steps) {}

    /// Returns whether anything moved.
    bool apply(DabContext& context, StepPlan& plan);

private:
    bool moveWithinLimits(DabContext& context, double part);
    bool tightenAndMove(DabContext& context, double part);
    bool optimiseAtOnce(DabContext& context);

    DabSteps& m_steps;
    SlotSet m_frozen; ///< vertices around the operations of an optimisation that were not sound
};
} // namespace core
