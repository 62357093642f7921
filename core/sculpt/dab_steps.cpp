#include "core/sculpt/dab_steps.h"

#include "core/mesh/normals.h"
#include "core/sculpt/boolean_dab.h"
#include "core/sculpt/dab_bounds.h"
#include "core/sculpt/dab_selection.h"
#include "core/sculpt/deform/deform.h"
#include "core/sculpt/deform/mirrored_deform.h"
#include "core/sculpt/deform/stamp_shape.h"
#include "core/sculpt/remesh/outline_cut.h"
#include "core/sculpt/select/selector.h"
#include "core/sculpt/verified_remesh.h"
#include "core/util/phase_timer.h"

#include <algorithm>

namespace core
{
namespace
{
/// A dab whose centre is farther than this from the centre of its mirror image, in radii, cannot touch the image.
constexpr double maxImageDistance = 4;
/// Smallest depth of a stamp, in d_detail, at which its outline is cut into the mesh.
constexpr double minDepth = 0.05;
/// Number of vertex pairs examined by fusion that cost as much time as one unit of WorkBudget. Charged because a mesh
/// far finer than the brush has many pairs within d_thickness.
constexpr double visitsPerWork = 128;
/// Largest number of rounds of cleaning a dab's joints. One round's merges may create joints next to other joints,
/// which the next round merges.
constexpr int maxCleaningRounds = 4;
/// Rounds of smoothing at joints (paper, section 3.4).
constexpr int jointSmoothings = 3;

/// Returns whether the tool takes several sub-steps at once even where surfaces face each other, as long as no contact
/// is predicted. The two sides of a crease, the walls of an imprint and the sides of a dragged part face each other but
/// seldom meet.
bool takesLongSteps(Tool tool)
{
    return sharpens(tool) || tool == Tool::Stamp || isDragTool(tool);
}

bool keepsShape(Tool tool)
{
    return sharpens(tool) || tool == Tool::Stamp;
}

FusionInput fusionInput(const DabContext& context, const StepPlan& plan)
{
    return {pushes(context.settings), context.bounds, plan.part(), context.rest(),
            visitsPerWork * context.request.work.left()};
}
} // namespace

void DabSteps::begin(DabContext& context)
{
    m_fusion.beginDab(context.mirror, detailShare(context.settings),
                      isDragTool(context.settings.tool) ? context.dab.radius : 0);
    const PhaseTimer timer(context.report.fuseMs);
    context.canFuse = canFacesFuse(context);
}

/// Returns whether faces may come into contact. For a ray brush or a grabbed region, the candidates contain only the
/// region's own part of the surface, so all faces near the region are examined.
bool DabSteps::canFacesFuse(const DabContext& context)
{
    const Sphere& ball = context.ball;
    const MirrorMap* mirror = context.mirror;
    if (mirror && (mirror->imageOf(ball.center) - ball.center).norm() < maxImageDistance * ball.radius)
        return true; // contact with the mirror image, even if nothing else is near
    if (context.settings.brush == BrushShape::Sphere && !context.grab.state.isOn)
        return FusionCandidates::mayFace(context.mesh(), context.region, context.candidates);
    const Selector selector(context.mesh(), context.surface.octree());
    return FusionCandidates::mayFace(context.mesh(), context.region, selector.facesIn(ball));
}

RemeshCounts DabSteps::refineAndPlan(DabContext& context, StepPlan& plan, MeshEditor edit)
{
    RemeshCounts counts;
    RestLengths* rest = context.rest();
    if (rest)
        rest->measure(context.region, context.mesh());
    if (context.settings.topology == Topology::Keep) {
        context.region.remeshed().clear(); // still set by an earlier dab
    } else if (!context.grab.state.isOn) {
        const PhaseTimer timer(context.report.optimiseMs, context.surface.verifyMs());
        counts = refine(edit, context.region, context.candidates, context.ball, context.bounds, rest);
        context.request.displacements.doubt(context.region.remeshed());
    }
    if (context.settings.brush == BrushShape::Ray && counts.splits > 0) {
        const PhaseTimer timer(context.report.selectMs);
        selectRefined(context, context.region);
        if (context.mirror)
            keepHalf(context.region, *context.mirror);
        if (rest)
            rest->measure(context.region, context.mesh());
    }
    m_outline.clear();
    if (context.settings.tool == Tool::Stamp && context.settings.topology != Topology::Keep) {
        const PhaseTimer timer(context.report.optimiseMs);
        counts += cutOutline(context, edit);
    }
    const PhaseTimer timer(context.report.deformMs, context.report.fuseMs);
    context.report.asked = this->plan(context);
    const EdgeBounds fine = context.grab.bounds(context.settings, context.mesh(), context.bounds);
    if (context.canFuse && takesLongSteps(context.settings.tool) && !context.limits.inUse()) {
        const PhaseTimer fuseTimer(context.report.fuseMs);
        context.canFuse = m_fusion.predictContact(context.surface, context.region, fine);
    }
    if (!context.canFuse)
        context.bounds = fine;
    plan.cut(context);
    context.isCapped = plan.isTooLong();
    return counts;
}

/// Returns the stamp's shape, placed on the selected surface. Stores the mean normal in the dab, because cutting the
/// outline changes the region.
StampShape DabSteps::stampShape(DabContext& context)
{
    const Region* selected = &context.region;
    if (context.mirror) {
        selectBothSides(context, m_whole);
        selected = &m_whole;
    }
    context.dab.normal = meanNormal(*selected, context.mesh());
    return {frameOn(*selected, context.mesh(), context.settings, context.dab), context.settings, context.dab};
}

/// Splits and moves edges so that the stamp's outline runs along edges, and its rim becomes sharp.
RemeshCounts DabSteps::cutOutline(DabContext& context, MeshEditor& edit)
{
    const StampShape shape = stampShape(context);
    const double least = minDepth * context.bounds.detail; // a surface already at the stamp's depth needs no outline
    const ShapeDepth depth = [&](const Vec3& p) {
        const double deep = shape.depthAt(p);
        return std::abs(deep) < least ? 0 : deep;
    };
    RemeshPass pass(edit, context.region, context.bounds, context.rest());
    m_outline = OutlineCut(pass, depth, context.ball).cut();
    return pass.counts;
}

bool DabSteps::stampSolid(DabContext& context)
{
    if (!context.settings.fusion || context.settings.brush != BrushShape::Sphere)
        return false;
    std::vector<Vec3> places;
    TriangleMesh mesh = stampShape(context).solid(context.bounds.detail, places);
    PlacedSolid solid(std::move(mesh), std::move(places), context.dab.position);
    const BooleanOperation operation = context.settings.inverted ? BooleanOperation::Unite : BooleanOperation::Subtract;
    return applyBoolean(context, std::move(solid), operation) == BooleanOutcome::Done;
}

/// Plans the displacement of each vertex. Returns the longest one, in mm.
double DabSteps::plan(DabContext& context)
{
    const StrokeSettings& settings = context.settings;
    if (settings.tool == Tool::Layer)
        context.request.displacements.fill(context.region, context.mesh(), context.mirror);
    Region& whole = context.mirror ? m_whole : context.region;
    if (context.mirror)
        selectBothSides(context, m_whole);
    context.region.forEach([&](Slot v) { // vertices added by the outline cut may be beyond the reach of a ray brush
        if (!whole.contains(v))
            whole.add(v, context.region.distance(v));
    });
    for (Slot v : m_outline.slots()) {
        if (whole.contains(v))
            whole.setCarried(v, 1);
    }
    const DeformInput input = {context.mesh(), settings, context.dab, context.request.displacements,
                               context.grab.state.moved};
    return context.mirror ? planMirrored(context.region, m_whole, *context.mirror, input)
                          : planDeformation(context.region, input);
}

bool DabSteps::displace(DabContext& context, double part)
{
    const Mesh& mesh = context.mesh();
    const Lattice& lattice = mesh.lattice();
    const Region& region = context.region;
    const MotionLimits& limits = context.limits;
    MeshEditor edit = context.editor();
    bool isInside = true;
    region.forEach([&](Slot v) {
        const double share = part * limits.share(region, v);
        const Vec3f before = mesh.point(v);
        const Vec3f after = edit.kept(v, lattice.snap(before.cast<double>() + share * region.plan(v)));
        isInside = isInside && lattice.contains(after.cast<double>());
        if (isInside && after != before)
            edit.move(v, after);
    });
    return isInside;
}

RemeshCounts DabSteps::optimise(DabContext& context, MeshEditor edit)
{
    EdgeBounds bounds = context.bounds;
    if (context.settings.topology == Topology::Keep)
        bounds.detail = std::numeric_limits<double>::max();
    const Mesh& mesh = context.mesh();
    const RestLengths* rest = context.rest();
    const auto relaxed = [&](Slot v) { return relaxedAlongSharp(mesh, bounds, v); };
    const auto evened = [&](Slot v) {
        return rest->wasSharp(v) ? Vec3(mesh.point(v).cast<double>()) : evenedAlongLine(mesh, v);
    };
    if (rest && isDragTool(context.settings.tool))
        moveSoundly(edit, context.region, bounds, evened);
    const RemeshCounts counts = keepsShape(context.settings.tool)
                                    ? optimiseKeepingShape(edit, context.region, bounds, relaxed, context.rest())
                                    : core::optimise(edit, context.region, bounds, context.rest());
    context.request.displacements.doubt(context.region.remeshed());
    return counts;
}

bool DabSteps::displaceAndOptimise(DabContext& context, double part, RemeshCounts& counts)
{
    {
        const PhaseTimer timer(context.report.deformMs);
        if (!displace(context, part))
            return false;
    }
    if (context.settings.topology == Topology::Keep)
        return true;
    const PhaseTimer timer(context.report.optimiseMs);
    counts += optimise(context, context.editor());
    return true;
}

bool DabSteps::join(DabContext& context, const StepPlan& plan)
{
    if (!context.settings.fusion || !context.canFuse)
        return false;
    const PhaseTimer timer(context.report.fuseMs, context.surface.verifyMs());
    const std::uint64_t joins =
        m_fusion.join(context.surface, context.region, context.limits, fusionInput(context, plan));
    context.request.work.spend(static_cast<double>(m_fusion.takeVisits()) / visitsPerWork);
    if (joins > 0)
        context.limits.clear();
    context.request.totals.fusions += joins;
    return joins > 0;
}

void DabSteps::separate(DabContext& context)
{
    if (!context.settings.fusion || context.blocked.empty())
        return;
    const PhaseTimer timer(context.report.fuseMs, context.surface.verifyMs());
    context.request.totals.separations +=
        m_fusion.separate(context.surface, context.region, context.blocked, context.bounds);
    context.blocked.clear();
}

void DabSteps::cleanJoints(DabContext& context)
{
    if (!m_fusion.hasJoints())
        return;
    if (m_fusion.hasJoined()) {
        m_fusion.addJoined(context.region, context.mesh(), context.dab.position);
        optimiseJoints(context);
    }
    for (int round = 0; round < maxCleaningRounds && separateJoints(context) > 0; ++round)
        optimiseJoints(context); // the caps of the cuts must be optimised too
}

/// Cuts thin necks where this stroke has joined surfaces, and merges adjacent joins of this dab. Returns the number of
/// changes.
std::uint64_t DabSteps::separateJoints(DabContext& context)
{
    std::uint64_t& separations = context.request.totals.separations;
    const std::uint64_t before = separations;
    separate(context);
    const PhaseTimer timer(context.report.fuseMs, context.surface.verifyMs());
    separations += m_fusion.cutCycles(context.surface, context.region, context.bounds, context.rest());
    return separations - before;
}

/// Smooths the joints and optimises the region. If that does not verify, only optimises; if that does not verify
/// either, only splits the edges that are too long.
void DabSteps::optimiseJoints(DabContext& context)
{
    if (context.settings.topology == Topology::Keep)
        return;
    const auto smoothAndOptimise = [&] {
        smoothJoints(context);
        return optimise(context, context.editor());
    };
    const auto optimiseOnly = [&] { return optimise(context, context.editor()); };
    const PhaseTimer timer(context.report.optimiseMs, context.surface.verifyMs());
    if (!remeshVerified(context, smoothAndOptimise) && !remeshVerified(context, optimiseOnly))
        splitVerified(context);
}

void DabSteps::smoothJoints(DabContext& context)
{
    const Mesh& mesh = context.mesh();
    const auto smoothed = [&](Slot v) {
        const Vec3 p = mesh.point(v).cast<double>();
        return m_fusion.isJoined(v) ? Vec3(0.5 * (p + neighbourMean(mesh, v))) : p;
    };
    MeshEditor edit = context.editor();
    for (int i = 0; i < jointSmoothings; ++i)
        moveSoundly(edit, context.region, context.bounds, smoothed);
}

bool DabSteps::isContact(const DabContext& context, const StepPlan& plan)
{
    return m_fusion.isContact(context.surface, context.region, fusionInput(context, plan), context.settings.fusion,
                              context.badVertices);
}
} // namespace core
