// Applies a dab at one place (paper, section 3; core/README.md, "A dab"). Four kinds of dab:
//   add        adds a solid, if the stroke asks for it                         3.5.1  add_solid
//   paint      changes colours or the mask                                     3.5.3  attribute_brush
//   join tip   joins the tip of Snake Hook to a surface within reach                  hook_tip
//   sculpt     all others, in the steps below
// Steps of a dab that sculpts:
//   select     selects the vertices under the brush                            3.1    dab_selection, select/
//   refine     makes the mesh fine enough to plan on                           3.2    dab_steps, remesh/
//   plan       plans each vertex's displacement, in sub-steps of <= d_move     3.3    dab_steps, deform/, step_plan
// Steps of each sub-step, or of several sub-steps at once where no surfaces can meet:
//   displace   moves each vertex by a part of its plan, onto the lattice       3.3    dab_steps
//   optimise   makes the mesh quasi-uniform again                              3.2    dab_steps, remesh/
//   commit     verifies the change exactly; updates octree and draw ranges            verify/
//   join       joins what the next sub-step would bring into contact           3.4    dab_steps, fuse/
//   separate   cuts thin necks and removes specks                              3.4    dab_steps, fuse/
// After the last sub-step, if anything has been joined:
//   clean      smooths and optimises the joints; closes narrow tunnels         3.4    dab_steps
//              and cuts narrow strands between them
// A sub-step that does not verify is rolled back and retried as listed at prepareRetry(). As a last resort,
// fallback_step limits the motion of each vertex.
// The paper smooths locally and optimises at each join (3.4). Here both are done once, after the last sub-step. In
// addition, fold_smoothing smooths folded surface before a retry.

#include "core/sculpt/dab_pipeline.h"

#include "core/sculpt/add_solid.h"
#include "core/sculpt/dab_bounds.h"
#include "core/sculpt/dab_selection.h"
#include "core/sculpt/deform/deform.h"
#include "core/sculpt/hook_tip.h"
#include "core/sculpt/verify/mesh_transaction.h"
#include "core/util/phase_timer.h"

#include <bit>
#include <utility>

namespace core
{
namespace
{
/// Largest number of attempts at the sub-steps of a dab. A guard against endless loops, not a tuning knob: a dab that
/// needs more ends early.
constexpr int maxAttempts = 4 * 4096;
/// Largest number of vertices in the warm-up dab. If the dab would select more, because the mesh is far finer there
/// than elsewhere, the warm-up is skipped.
constexpr Slot maxWarmUpVertices = 1024;
/// Depth, in radii, beyond which a stamp that one transaction cannot complete is done as a solid. A shallower solid
/// would nearly coincide with the surface that an earlier stamp left, and cross it in many places.
constexpr double deepStamp = 0.3;
/// Largest number of fallback steps between two tries without motion limits.
constexpr unsigned maxLimitedSteps = 8;

/// Returns whether this sub-step is to be tried without motion limits. The limits persist across sub-steps. They are
/// lifted for one try after 1, 2, 4, 8, then every 8 sub-steps, in case the obstacle is gone.
bool shouldLiftLimits(const DabContext& context)
{
    return std::has_single_bit(context.fallbackSteps) || context.fallbackSteps % maxLimitedSteps == 0;
}

/// Returns whether limits have kept the motion back that may still be made up for. A tool that moves vertices to a
/// place must not move them past it, and a hand that drags must not be overtaken.
bool lagsBehind(const DabContext& context)
{
    const Tool tool = context.settings.tool;
    const bool movesByLength = tool == Tool::Pull || tool == Tool::Push || tool == Tool::Inflate;
    return movesByLength && !context.report.isWhole() && !context.report.contact;
}

bool isDeep(const DabContext& context)
{
    return context.report.asked > deepStamp * context.dab.radius;
}
} // namespace

void DabPipeline::apply(DabContext& context)
{
    {
        const PhaseTimer timer(context.report.selectMs);
        selectRegion(context);
    }
    applyToRegion(context);
}

void DabPipeline::applyToRegion(DabContext& context)
{
    const StrokeSettings& settings = context.settings;
    if (wantsSolid(context.surface, settings, context.dab, context.region))
        addSolid(context);
    else if (paintsAttribute(settings.tool))
        m_attributeBrush.apply(context);
    else if (!joinHookTip(context))
        sculpt(context);
}

void DabPipeline::sculpt(DabContext& context)
{
    begin(context);
    deform(context);
    m_steps.cleanJoints(context);
    finish(context);
}

void DabPipeline::begin(DabContext& context)
{
    const Grab& grab = context.grab;
    context.dab.axis = grab.state.axis;
    if (grab.state.isOn)
        context.ball = grab.ball(context.mesh());
    m_foldSmoothing.clear();
    m_mayStampSolid = context.settings.tool == Tool::Stamp;
    m_steps.begin(context);
    if (StrokeDisplacements::areUsedBy(context.settings))
        context.request.displacements.meet(context.region, context.mirror);
    if (grab.isLimitedFor(context.dab)) {
        context.limits = std::move(context.grab.state.limits);
        context.fallbackSteps = grab.state.fallbackSteps;
        context.allowFusion();
    }
}

/// Does the sub-steps of the plan until the plan is done, a sub-step fails for good, or the work budget is spent.
void DabPipeline::deform(DabContext& context)
{
    StepPlan plan;
    bool isExtended = false;
    WorkBudget& work = context.request.work;
    DabReport& report = context.report;
    report.outcome = DabOutcome::Committed;
    for (int attempt = 0; !plan.isDone(); ++attempt, work.spend(context.region.size())) {
        const bool isTooMuch = attempt >= maxAttempts || work.isSpent();
        const Step result = isTooMuch ? Step::Failed : step(context, plan);
        if (result == Step::Retry)
            continue;
        if (result == Step::Whole) {
            report.substeps = 1;
            report.reached = report.asked;
            break;
        }
        if (result == Step::Empty) { // nothing was selected, or everything under the brush has vanished
            if (report.substeps == 0)
                report.outcome = DabOutcome::Empty;
            break;
        }
        if (isExtended && (result == Step::Failed || context.isCapped))
            break; // the plan was done before
        if (result == Step::Failed || context.isCapped) {
            report.outcome = DabOutcome::EndedEarly;
            report.capped = isTooMuch || context.isCapped || work.isSpent();
            break;
        }
        report.substeps += plan.substeps();
        plan.advance();
        if (plan.isDone() && lagsBehind(context))
            isExtended = plan.extend(1 - report.reached / report.asked) || isExtended;
        if (result == Step::Fallback) {
            report.outcome = DabOutcome::Fallback;
            ++context.fallbackSteps;
        }
        if (context.request.afterSubstep)
            context.request.afterSubstep();
    }
}

/// Does the next sub-step directly, unless motion limits are in force. If it fails, prepares a retry or does the
/// fallback step.
DabPipeline::Step DabPipeline::step(DabContext& context, StepPlan& plan)
{
    const bool isLimited = context.limits.inUse();
    if (!isLimited || shouldLiftLimits(context)) {
        MotionLimits limits = std::exchange(context.limits, {});
        const Step result = directStep(context, plan);
        if (result != Step::Failed)
            return result;
        context.limits = std::move(limits);
        if (!isLimited && !plan.isCut() && isDeep(context) && std::exchange(m_mayStampSolid, false) &&
            m_steps.stampSolid(context))
            return Step::Whole;
        if (!isLimited && prepareRetry(context, plan))
            return Step::Retry;
    }
    const bool hasMoved = m_fallback.apply(context, plan);
    m_steps.separate(context);
    return hasMoved ? Step::Fallback : Step::Failed;
}

/// Does a sub-step in one transaction. The first one also refines the mesh and makes the plan. A deep stamp that needs
/// more than one transaction returns Failed, so that step() tries it as a solid.
DabPipeline::Step DabPipeline::directStep(DabContext& context, StepPlan& plan)
{
    MeshTransaction transaction(context.surface, context.region); // its destructor rolls back, unless it was committed
    const bool isFirst = !plan.isCut();
    RemeshCounts counts;
    if (isFirst)
        counts = m_steps.refineAndPlan(context, plan, context.editor()); // paper, 3.2 and 3.3
    if (context.region.empty())
        return Step::Empty;
    if (m_mayStampSolid && !plan.isLast() && isDeep(context)) {
        plan.discard();
        return Step::Failed;
    }
    context.badVertices.clear();
    const bool isInside = m_steps.displaceAndOptimise(context, plan.part(), counts); // paper, 3.3 and 3.2
    if (!isInside || !transaction.commit()) {
        if (isInside)
            context.badVertices = cornersOf(context.mesh(), context.surface.badFaces());
        if (isFirst)
            plan.discard();
        ++context.request.totals.rolledBack;
        return Step::Failed;
    }
    context.count(counts);
    context.report.reached += plan.part() * context.report.asked;
    m_steps.join(context, plan); // paper, 3.4
    m_steps.separate(context);
    return Step::Direct;
}

/// Prepares the retry of a direct sub-step that failed, by the first of these methods that applies:
///   1. The first sub-step refines and moves in one transaction. If it failed, the mesh is refined alone; if that does
///      not verify either, returns false. Otherwise the list goes on with 2.
///   2. A transaction of several sub-steps is halved.
///   3. Surfaces that are about to meet are joined, if fusion is allowed.
///   4. Odd retries smooth the surface around the bad faces (FoldSmoothing); the first retry moves no vertex back
///      against its plan. If smoothing moves nothing, the plan is smoothed instead.
///   5. Even retries smooth the plan around the bad faces, and halve the sub-step, down to an eighth.
/// Returns false if the fallback step is to do the sub-step: after 6 retries of the sub-step by 4 and 5, or 12 in the
/// dab.
bool DabPipeline::prepareRetry(DabContext& context, StepPlan& plan)
{
    if (!plan.isCut() && !refineAndPlanAlone(context, plan)) {
        context.allowFusion();
        return false;
    }
    if (plan.halveTransaction())
        return true;
    context.allowFusion();
    if (m_steps.join(context, plan))
        return true;
    context.report.contact = context.report.contact || m_steps.isContact(context, plan);
    if (!plan.mayRetry())
        return false;
    const std::vector<Slot>& bad = context.badVertices;
    const bool isOdd = plan.retries() % 2 == 1, mayTakeBack = plan.retries() > 1;
    if (isOdd && m_foldSmoothing.smooth(context.surface, context.editor(), context.region, bad, mayTakeBack))
        return true;
    smoothPlan(context.region, context.mesh(), bad);
    if (!isOdd)
        plan.halveStep();
    return true;
}

/// Refines the mesh and makes the plan in a transaction of its own. The first sub-step probably failed because of its
/// motion, not because of the refinement.
bool DabPipeline::refineAndPlanAlone(DabContext& context, StepPlan& plan)
{
    MeshTransaction transaction(context.surface, context.region);
    const RemeshCounts counts = m_steps.refineAndPlan(context, plan, context.editor());
    if (!transaction.commit()) {
        plan.discard();
        return false;
    }
    context.count(counts);
    return true;
}

/// Completes the report, and stores what the next dab of the stroke needs: displacements, grab and motion limits.
void DabPipeline::finish(DabContext& context)
{
    DabReport& report = context.report;
    Grab& grab = context.grab;
    context.request.bounds = context.bounds;
    if (report.asked > 0)
        report.reached = m_foldSmoothing.shareLeft(context.region, report.reached / report.asked) * report.asked;
    report.touchedVertices = context.touchedVertices();
    if (StrokeDisplacements::areUsedBy(context.settings) && report.asked > 0)
        context.request.displacements.note(context.region, context.mesh(), report.reached / report.asked,
                                           context.mirror);
    if (!keepsSelection(context.settings.tool) || context.region.empty())
        return;
    const double share = report.asked > 0 ? report.reached / report.asked : 0;
    grab.keep(context.mesh(), context.mirror != nullptr,
              share * std::min(context.dab.strength, 1.0) * context.dab.motion);
    if (context.limits.inUse() && report.isWhole()) // otherwise these limits are too tight to be reused
        grab.noteLimits(context.dab, std::move(context.limits), context.fallbackSteps);
}

void DabPipeline::warmUp(DabContext& context)
{
    Mesh& mesh = context.surface.mesh();
    mesh.beginStroke();
    const Mesh::Mark mark = mesh.mark();
    selectRegion(context);
    if (context.region.size() <= maxWarmUpVertices) {
        StepPlan plan;
        RemeshCounts counts = m_steps.refineAndPlan(context, plan, context.editor());
        m_steps.displaceAndOptimise(context, plan.part(), counts);
        context.surface.warmUp(mark);
    }
    mesh.rollback(mark);
    mesh.endStroke();
    context.region.clear();
}
} // namespace core
