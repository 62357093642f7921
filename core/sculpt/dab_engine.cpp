// A dab in sub-steps (paper, section 3; DESIGN, section 3):
//   select   the vertices under the brush                                                      region
//   refine   the mesh under the brush becomes fine enough to plan on                           remesh
//   plan     how far each is to move, in all                                                   deform
// then, for each sub-step no longer than d_move, or for several at once where nothing can meet:
//     deform     each vertex moves its part of the plan, snapped to the lattice
//     optimise   the mesh under the brush becomes quasi-uniform where it now is                remesh
//     verify     exactly, where it changed                                                     verified_mesh
//     index      octree and draw ranges learn what changed                                     verified_mesh
//     fuse       what the next sub-step would bring into contact joins; thin necks part        fuse
// It is planned in step_plan.cpp. What it works on is selected in dab_selection.cpp, or is what an earlier dab of the
// stroke took hold of, in grab_state.cpp; a sub-step that does not verify is rolled back and goes on in
// fallback_step.cpp. Of several sectors radial_dabs.cpp does one after the other.

#include "core/sculpt/dab_engine.h"

#include "core/sculpt/add_solid.h"
#include "core/util/phase_timer.h"

#include <utility>

namespace core
{
namespace
{
/// A guard, not a tuning knob: tries to take the steps of a dab, which ends early if it would need more.
constexpr int maxAttempts = 4 * 4096;
/// A dab whose centre is farther from its image's than this, in radii, does not bring the two into contact.
constexpr double farthestFromImage = 4;
/// Vertices of the warm-up dab at most: where the mesh is far finer than elsewhere there is none.
constexpr Slot maxWarmUpVertices = 1024;

bool isAtRest(const StrokeSettings& settings, const Dab& dab)
{
    return isDragTool(settings.tool) && (settings.tool == Tool::Twist ? dab.turn == 0 : dab.motion.isZero());
}
} // namespace

DabEngine::DabEngine(Mesh& mesh) : m_mesh(mesh), m_surface(mesh), m_mirror(mesh)
{
    warmUp();
}

/// A dab that is taken back before it counts. Memory that is touched for the first time costs far more than a dab: so
/// the first real one costs what all do. At the last vertex: what has room for it has room for all.
void DabEngine::warmUp()
{
    if (m_mesh.live().vertices == 0)
        return;
    Slot v = m_mesh.slots().vertices - 1;
    while (!m_mesh.isVertex(v))
        --v;
    const StrokeSettings settings;
    Dab dab;
    dab.position = m_mesh.point(v).cast<double>();
    dab.radius = m_mesh.uniformDetail() / edgeBounds(1, settings.detail).detail;
    dab.strength = 1;
    DabReport report;
    m_mesh.beginStroke();
    const Mesh::Mark mark = m_mesh.mark();
    select(m_region, m_candidates, BrushShape::Sphere, {dab.position, dab.radius});
    if (m_region.size() <= maxWarmUpVertices) {
        Task task = {settings, dab, {dab.position, dab.radius}, boundsFor(settings, dab.radius)};
        RemeshCounts counts = refineAndPlan(task, plainEditor(), report);
        moveAndOptimise(task, counts, report);
        m_surface.warmUp(mark);
    }
    m_mesh.rollback(mark);
    m_mesh.endStroke();
    m_region.clear();
}

DabReport DabEngine::apply(const StrokeSettings& settings, const Dab& dab, const std::function<void()>& between)
{
    DabReport report;
    m_bounds.reset();
    m_work = 0;
    if (!(dab.strength > 0))
        return report;
    if (isAtRest(settings, dab))
        return rest(settings, dab);
    const double verifiedBefore = m_surface.verifyMs();
    m_surface.forgetDirtyFaces();
    {
        const PhaseTimer timer(report.totalMs);
        if (settings.radial > 1)
            runRadial(settings, dab, between, report);
        else
            runOnce(settings, dab, between, report);
    }
    report.verifyMs = m_surface.verifyMs() - verifiedBefore;
    if (report.touchedFaces == 0)
        report.touchedFaces = m_surface.maxDirtyFaces();
    return report;
}

/// The region is selected.
void DabEngine::sculpt(const StrokeSettings& settings, Dab dab, const std::function<void()>& between, DabReport& report)
{
    if (wantsSolid(settings, dab)) {
        report = addSolid(m_surface, settings.model.get(), dab, mirror());
        return;
    }
    if (paintsAttribute(settings.tool))
        return mark(settings, dab, report);
    m_limits.clear();
    m_foldSmoothing.clear();
    m_fusion.beginDab(mirror(), detailShare(settings));
    m_blocked.clear();
    m_capped = false;
    dab.axis = m_grab.axis;
    Task task = {settings, dab, ballAround(dab), boundsFor(settings, dab.radius)};
    {
        const PhaseTimer timer(report.fuseMs);
        task.canFuse = canFacesFuse(settings, task.ball);
    }
    recallLimits(task);
    deform(task, between, report);
    m_bounds = task.bounds;
    if (report.asked > 0)
        report.reached = m_foldSmoothing.shareLeft(m_region, report.reached / report.asked) * report.asked;
    report.touchedVertices = touchedVertices();
    if (settings.tool == Tool::Layer && report.asked > 0)
        noteRaised(report.reached / report.asked);
    if (keepsSelection(settings.tool) && !m_region.empty()) {
        m_grab = {true, m_mirror.isOn(), m_grab.axis, m_grab.detail, m_mesh.removedVertices().size()};
        noteLimits(task, report);
    }
}

/// In sub-steps, until the plan is done or no more can be.
void DabEngine::deform(Task& task, const std::function<void()>& between, DabReport& report)
{
    report.outcome = DabOutcome::Committed;
    for (int attempt = 0; task.steps == 0 || task.left > 0; ++attempt, m_work += m_region.size()) {
        const bool tooMuch = attempt >= maxAttempts || isSpent();
        const Substep result = tooMuch ? Substep::Failed : substep(task, report);
        if (result == Substep::Retry)
            continue;
        if (result == Substep::Empty) { // from the start, or because all that was under the brush has vanished
            if (report.substeps == 0)
                report.outcome = DabOutcome::Empty;
            break;
        }
        if (result == Substep::Failed || m_capped) {
            report.outcome = DabOutcome::EndedEarly;
            report.capped = tooMuch || m_capped || isSpent();
            break;
        }
        report.substeps += task.substeps();
        task.left -= task.ticks;
        task.retries = 0;
        task.ticks = std::min({2 * task.ticks, task.maxTicks, task.left});
        if (result == Substep::Fallback) {
            report.outcome = DabOutcome::Fallback;
            ++task.fallbackSubsteps;
        }
        if (between)
            between();
    }
}

DabEngine::Substep DabEngine::substep(Task& task, DabReport& report)
{
    const bool isLimited = m_limits.inUse();
    if (!isLimited || task.shouldRelax()) {
        MotionLimits limits = std::exchange(m_limits, {});
        const Region::Saved saved = m_region.save();
        const double steps = task.steps;
        const Substep result = direct(task, report);
        if (result == Substep::Direct) {
            join(task, report);
            separate(task, report);
        }
        if (result != Substep::Failed)
            return result;
        m_limits = std::move(limits);
        m_region.restore(saved);
        task.steps = steps;
        ++m_totals.rolledBack;
        if (!isLimited && easeMotion(task, report))
            return Substep::Retry;
    }
    const Substep result = fallback(task, report);
    separate(task, report);
    return result;
}

DabEngine::Substep DabEngine::direct(Task& task, DabReport& report)
{
    const Mesh::Mark mark = m_mesh.mark();
    RemeshCounts counts;
    if (task.steps == 0)
        counts += refineAndPlan(task, plainEditor(), report);
    if (m_region.empty()) {
        m_mesh.rollback(mark);
        return Substep::Empty;
    }
    m_badVertices.clear();
    const bool inside = moveAndOptimise(task, counts, report);
    if (!inside || !m_surface.verify(mark)) {
        for (Slot f : inside ? m_surface.badFaces() : std::vector<Slot>())
            m_badVertices.insert(m_badVertices.end(), m_mesh.corners(f).begin(), m_mesh.corners(f).end());
        m_mesh.rollback(mark);
        return Substep::Failed;
    }
    count(counts);
    report.reached += task.part() * report.asked;
    return Substep::Direct;
}

/// Neither verified nor rolled back. False if a vertex would leave the working volume.
bool DabEngine::moveAndOptimise(const Task& task, RemeshCounts& counts, DabReport& report)
{
    {
        const PhaseTimer timer(report.deformMs);
        if (!displace(task.part()))
            return false;
    }
    const PhaseTimer timer(report.optimiseMs);
    counts += remesh(task, plainEditor());
    return true;
}

/// What a tool has made sharp stays so.
RemeshCounts DabEngine::remesh(const Task& task, MeshEditor edit)
{
    if (!sharpens(task.settings.tool) && task.settings.tool != Tool::Stamp)
        return optimise(edit, m_region, task.bounds);
    return optimiseKeepingShape(edit, m_region, task.bounds,
                                [&](Slot v) { return relaxedAlongSharp(m_mesh, task.bounds, v); });
}

/// Moves each vertex of the region by its part of the plan. False if one would leave the working volume.
bool DabEngine::displace(double part)
{
    const Lattice& lattice = m_mesh.lattice();
    MeshEditor edit = plainEditor();
    bool inside = true;
    m_region.forEach([&](Slot v) {
        const double share = part * m_limits.share(m_region, v);
        const Vec3f before = m_mesh.point(v);
        const Vec3f after = edit.kept(v, lattice.snap(before.cast<double>() + share * m_region.plan(v)));
        inside = inside && lattice.contains(after.cast<double>());
        if (inside && after != before)
            edit.move(v, after);
    });
    return inside;
}

/// Whether there is anything for fusion to join. A brush along the surface has only its own sheet for candidates.
bool DabEngine::canFacesFuse(const StrokeSettings& settings, const Sphere& ball)
{
    if (m_mirror.isOn() && (m_mirror.imageOf(ball.center) - ball.center).norm() < farthestFromImage * ball.radius)
        return true; // the image may be all that there is to meet
    if (settings.brush == BrushShape::Sphere && !m_grab.isOn)
        return TopologyFusion::mayFuse(m_mesh, m_region, m_candidates);
    return TopologyFusion::mayFuse(m_mesh, m_region, facesIn(latticeBox(m_mesh.lattice(), ball)));
}

/// Before the motion of a sub-step that is to come.
bool DabEngine::join(Task& task, DabReport& report)
{
    if (!task.settings.fusion || !task.canFuse)
        return false;
    const PhaseTimer timer(report.fuseMs, m_surface.verifyMs());
    const FusionCounts counts = m_fusion.join(m_surface, m_region, m_limits, task.fusionInput());
    if (counts.fusions > 0)
        m_limits.clear();
    m_totals.fusions += counts.fusions;
    return counts.fusions > 0;
}

void DabEngine::separate(Task& task, DabReport& report)
{
    if (!task.settings.fusion || m_blocked.empty())
        return;
    const PhaseTimer timer(report.fuseMs, m_surface.verifyMs());
    m_totals.separations += m_fusion.separate(m_surface, m_region, m_blocked, task.bounds).separations;
    m_blocked.clear();
}

SculptorTotals DabEngine::totals() const
{
    SculptorTotals totals = m_totals;
    totals.verifyTiers = m_surface.tiers();
    return totals;
}

void DabEngine::count(const RemeshCounts& counts)
{
    m_totals.splits += counts.splits;
    m_totals.collapses += counts.collapses;
    m_totals.flips += counts.flips;
    m_blocked = counts.blocked;
    m_capped = m_capped || counts.capped;
}
} // namespace core
