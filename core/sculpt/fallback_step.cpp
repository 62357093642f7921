// A sub-step that did not verify and was rolled back is made easier, a few times:
//   join      what was about to meet
//   smooth    what has folded up, or else: calm the motion, and halve the step
// and then done by the fallback step: first the motion alone, limited where it would touch something; then each
// remeshing operation by itself, verified one by one. What cannot be done is left undone.

#include "core/sculpt/dab_engine.h"

#include "core/sculpt/deform/deform.h"
#include "core/util/phase_timer.h"

namespace core
{
namespace
{
/// Rounds of tightening, and after how many of these one more ring of vertices around the bad faces is limited.
constexpr int maxTightenRounds = 64, roundsPerRing = 4;
/// Of remeshing at once, before what is left is done operation by operation.
constexpr int maxFreezeRounds = 16;
} // namespace

/// After a sub-step that failed: what was about to meet is joined; failing that, in turns, what has folded up is
/// smoothed, or the motion is made calmer where faces turned over and the step is halved.
bool DabEngine::easeMotion(Task& task, DabReport& report)
{
    if (task.steps == 0 && !refineAtOnce(task, report)) {
        allowFusion(task);
        return false;
    }
    if (shortenStep(task))
        return true;
    allowFusion(task);
    if (join(task, report))
        return true;
    report.contact = report.contact ||
                     m_fusion.isContact(m_surface, m_region, task.fusionInput(), task.settings.fusion, m_badVertices);
    if (++task.retries > maxRetriesPerSubstep || ++task.totalRetries > maxRetriesPerDab)
        return false;
    if (task.retries % 2 == 1 &&
        m_foldSmoothing.smooth(m_surface, plainEditor(), m_region, m_badVertices, task.retries > 1))
        return true;
    smoothPlan(m_region, m_mesh, m_badVertices);
    if (task.retries % 2 == 0)
        task.ticks = std::max(task.ticks / 2, 1u);
    return true;
}

/// What was to be kept fine is not any more.
void DabEngine::allowFusion(Task& task) const
{
    task.canFuse = true;
    task.bounds = boundsFor(task.settings, task.dab.radius);
}

/// Of several sub-steps at once half is tried. False if it was one, or a part of one.
bool DabEngine::shortenStep(Task& task)
{
    if (task.ticks <= ticksPerStep)
        return false;
    task.maxTicks = task.ticks = std::max(task.ticks / 2, ticksPerStep);
    return true;
}

/// The mesh under the brush is made fine enough in a transaction of its own: what failed was more likely the motion.
bool DabEngine::refineAtOnce(Task& task, DabReport& report)
{
    const Region::Saved saved = m_region.save();
    const Mesh::Mark mark = m_mesh.mark();
    const RemeshCounts counts = refineAndPlan(task, plainEditor(), report);
    if (!m_surface.verify(mark)) {
        m_mesh.rollback(mark);
        m_region.restore(saved);
        task.steps = 0;
        return false;
    }
    count(counts);
    return true;
}

DabEngine::Substep DabEngine::fallback(Task& task, DabReport& report)
{
    if (task.steps == 0) {
        count(refineAndPlan(task, verifiedEditor(), report));
        allowFusion(task);
    }
    task.maxTicks = ticksPerStep; // limited vertices stay, and the mesh between that and what moves has to follow
    task.ticks = std::min(task.maxTicks, task.left);
    join(task, report);
    if (moveWithinLimits(task, report))
        return Substep::Fallback;
    const bool moved = tightenAndMove(task.part(), report);
    if (!optimiseAtOnce(task, report)) {
        const PhaseTimer timer(report.optimiseMs, m_surface.verifyMs());
        count(remesh(task, verifiedEditor()));
    }
    return moved ? Substep::Fallback : Substep::Failed;
}

/// Motion and operations in one transaction: the limits of an earlier sub-step are mostly enough.
bool DabEngine::moveWithinLimits(const Task& task, DabReport& report)
{
    if (!m_limits.inUse())
        return false;
    m_limits.extend(m_region, m_mesh);
    const double share = shareOfPeak();
    if (share == 0)
        return false;
    const Region::Saved saved = m_region.save();
    const Mesh::Mark mark = m_mesh.mark();
    RemeshCounts counts;
    if (!moveAndOptimise(task, counts, report) || !m_surface.verify(mark)) {
        m_mesh.rollback(mark);
        m_region.restore(saved);
        return false;
    }
    count(counts);
    report.reached += share * task.part() * report.asked;
    return true;
}

/// All operations in one transaction: what stopped the direct step was most likely the motion, not one of them. Failing
/// that, all but those around faces that went bad. False if these are left, or all.
bool DabEngine::optimiseAtOnce(Task& task, DabReport& report)
{
    m_frozen.clear();
    for (int round = 0; round < maxFreezeRounds; ++round) {
        const Region::Saved saved = m_region.save();
        const Mesh::Mark mark = m_mesh.mark();
        RemeshCounts counts;
        {
            const PhaseTimer timer(report.optimiseMs);
            counts = remesh(task, MeshEditor(m_mesh, {}, mirror(), &m_frozen));
        }
        if (m_surface.verify(mark)) {
            count(counts);
            return round == 0;
        }
        const std::vector<Slot> around = namedAround(m_surface.badFaces());
        m_mesh.rollback(mark);
        m_region.restore(saved);
        for (Slot v : around) {
            if (v < m_mesh.slots().vertices && m_mesh.isVertex(v))
                m_frozen.add(v);
        }
    }
    return false;
}

/// The corners of the faces and their neighbours; with a mirror those of the half, or their images there.
std::vector<Slot> DabEngine::namedAround(std::span<const Slot> faces)
{
    std::vector<Slot> named;
    const auto add = [&](Slot v) {
        if (const Slot half = m_mirror.isOn() && !m_mirror.isInHalf(v) ? m_mirror.imageOf(v) : v; half != noSlot)
            named.push_back(half);
    };
    for (Slot f : faces) {
        for (Slot v : m_mesh.corners(f)) {
            add(v);
            m_mesh.forEachOutgoing(v, [&](Slot h) { add(m_mesh.to(h)); });
        }
    }
    return named;
}

/// Moves every vertex as far as it can go without contact. Terminates: each round succeeds or fixes a vertex for the
/// rest of the dab. What a round has changed is looked at first, and all only when that is in order.
bool DabEngine::tightenAndMove(double part, DabReport& report)
{
    m_limits.extend(m_region, m_mesh);
    std::vector<Slot> tightened;
    for (int round = 0; round < maxTightenRounds; ++round) {
        const double share = shareOfPeak();
        if (share == 0 || isSpent())
            return false;
        m_work += m_region.size();
        const Mesh::Mark mark = m_mesh.mark();
        bool inside = false;
        {
            const PhaseTimer timer(report.deformMs);
            inside = displace(part);
        }
        if (inside && (round == 0 || m_surface.recheck(withImages(tightened)))) {
            m_work += fallbackMoveWork * m_region.size();
            if (m_surface.verify(mark)) {
                report.reached += share * part * report.asked;
                return true;
            }
        }
        m_mesh.rollback(mark);
        report.wall = !inside;
        if (!inside)
            return false;
        tightened = m_limits.tighten(m_region, m_mesh, m_surface.badFaces(), 1 + round / roundsPerRing);
        if (tightened.empty())
            return false;
    }
    return false;
}

std::vector<Slot> DabEngine::withImages(std::vector<Slot> vertices)
{
    if (!m_mirror.isOn())
        return vertices;
    for (std::size_t i = 0, n = vertices.size(); i < n; ++i) {
        if (const Slot image = m_mirror.imageOf(vertices[i]); image != noSlot && image != vertices[i])
            vertices.push_back(image);
    }
    return vertices;
}

/// Of the longest displacement planned, the share that the limited motion reaches. What is no longer there, being
/// joined or collapsed, has no say.
double DabEngine::shareOfPeak() const
{
    double planned2 = 0, reached2 = 0;
    m_region.forEach([&](Slot v) {
        const double plan2 = m_region.plan(v).squaredNorm(), share = m_limits.share(m_region, v);
        planned2 = std::max(planned2, plan2);
        reached2 = std::max(reached2, share * share * plan2);
    });
    return planned2 > 0 ? std::sqrt(reached2 / planned2) : 0;
}

/// Each operation by itself, until the dab has done all the work that it may: what is left is left undone.
MeshEditor DabEngine::verifiedEditor()
{
    const auto tryOperation = [this](const std::function<void()>& operation) {
        if (isSpent()) {
            m_capped = true;
            return false;
        }
        const bool done = m_surface.tryOperation(operation);
        m_work += m_surface.facesVisited();
        return done;
    };
    return MeshEditor(m_mesh, tryOperation, mirror());
}
} // namespace core
