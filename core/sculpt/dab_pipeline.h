#pragma once

#include "core/sculpt/attribute_brush.h"
#include "core/sculpt/fallback_step.h"
#include "core/sculpt/fuse/fold_smoothing.h"

namespace core
{
/// Applies a dab at one place (paper, section 3). Selects the region and refines its mesh once. Then each sub-step
/// displaces the vertices, optimises the mesh, verifies the change and fuses surfaces. The paper optimises before it
/// deforms; here a sub-step optimises what its own motion has stretched. Each sub-step is a transaction: one that does
/// not verify is rolled back, and retried in an easier way.
class DabPipeline
{
public:
    /// Forgets the stroke before.
    void beginStroke() { m_steps.beginStroke(); }

    /// Applies the dab of the context. Precondition: a stroke is open.
    void apply(DabContext& context);
    /// Applies the dab to a region that is selected already. Preconditions: a stroke is open, the region is selected.
    void applyToRegion(DabContext& context);

    /// Runs a dab and rolls it back: memory is then allocated, so the first real dab takes no longer than later ones.
    /// Precondition: no stroke is open.
    void warmUp(DabContext& context);

private:
    enum class Step { Direct, Whole, Fallback, Retry, Failed, Empty };

    void sculpt(DabContext& context);
    void begin(DabContext& context);
    void finish(DabContext& context);
    void deform(DabContext& context);
    Step step(DabContext& context, StepPlan& plan);
    Step directStep(DabContext& context, StepPlan& plan);
    bool prepareRetry(DabContext& context, StepPlan& plan);
    bool refineAndPlanAlone(DabContext& context, StepPlan& plan);

    DabSteps m_steps;
    FallbackStep m_fallback{m_steps};
    FoldSmoothing m_foldSmoothing;
    AttributeBrush m_attributeBrush;
    bool m_mayStampSolid = false; ///< a stamp that has not been tried as a solid yet
};
} // namespace core
