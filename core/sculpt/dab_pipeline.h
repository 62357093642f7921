#pragma once

#include "core/sculpt/attribute_brush.h"
#include "core/sculpt/fallback_step.h"
#include "core/sculpt/fuse/fold_smoothing.h"

namespace core
{
/// Applies a dab at one place (paper, section 3). Selects the region and refines its mesh once. Then each sub-step
/// displaces the vertices, optimises the mesh, verifies the change and fuses surfaces. The paper optimises before it
/// deforms. Here each sub-step optimises the mesh after its own motion has stretched it. Each sub-step is a
/// transaction: if it does not verify, it is rolled back and retried in an easier way.
class DabPipeline
{
public:
    /// Clears the state of the previous stroke.
    void beginStroke() { m_steps.beginStroke(); }

    /// Selects the region and applies the context's dab to it. Precondition: a stroke is open.
    void apply(DabContext& context);
    /// Applies the dab to the context's region. Preconditions: a stroke is open, the region is selected.
    void applyToRegion(DabContext& context);

    /// Runs a dab and rolls it back. Its only effect is to allocate memory, so that the first real dab is as fast as
    /// later ones. Precondition: no stroke is open.
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
    bool m_mayStampSolid = false; ///< the tool is Stamp, and this dab has not yet tried to stamp as a solid
};
} // namespace core
