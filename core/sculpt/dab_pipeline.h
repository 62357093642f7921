#pragma once

#include "core/sculpt/attribute_brush.h"
#include "core/sculpt/fallback_step.h"
#include "core/sculpt/fuse/fold_smoothing.h"

namespace core
{
/// One dab at one place, in the order of the paper's section 3: select, optimise the mesh, deform it in sub-steps,
/// fuse. Each sub-step is a transaction: what does not verify is rolled back, and tried again in an easier way.
class DabPipeline
{
public:
    /// Precondition of the following: a stroke is open.
    void apply(DabContext& context);
    /// Does the same from the second step on. Precondition: the region is selected.
    void applyToRegion(DabContext& context);

    /// Does a dab in memory that was never touched, and rolls it back: so that the first real one costs what all do.
    void warmUp(DabContext& context);

private:
    enum class Step { Direct, Fallback, Retry, Failed, Empty };

    void sculpt(DabContext& context);
    void begin(DabContext& context);
    void finish(DabContext& context);
    void deform(DabContext& context);
    Step step(DabContext& context, StepPlan& plan);
    Step directStep(DabContext& context, StepPlan& plan);
    bool ease(DabContext& context, StepPlan& plan);
    bool refineAndPlanAlone(DabContext& context, StepPlan& plan);

    DabSteps m_steps;
    FallbackStep m_fallback{m_steps};
    FoldSmoothing m_foldSmoothing;
    AttributeBrush m_attributeBrush;
};
} // namespace core
