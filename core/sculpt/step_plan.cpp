// How far a dab means to move what is under the brush, how fine it makes the mesh there, and into how many steps that
// is cut (paper, section 3.3).

#include "core/sculpt/dab_engine.h"

#include "core/sculpt/deform/deform.h"
#include "core/sculpt/deform/mirrored_deform.h"
#include "core/util/parallel.h"
#include "core/util/phase_timer.h"

namespace core
{
namespace
{
/// d_move in terms of d: the paper asks for less than d/2 (section 3.3).
constexpr double movePerMinimum = 0.45;
/// A guard, not a tuning knob: steps that a plan is cut into. A dab that would need more ends early.
constexpr double maxSteps = 4096;
/// A line is sharp if the mesh along it is fine, and so is what an alpha or a stamp has in it.
constexpr double lineDetail = 0.5, alphaDetail = 0.35, stampDetail = 0.28;
/// What a core takes at a time.
constexpr std::size_t verticesPerChunk = 512;

/// Even where surfaces face each other, as long as none stops it: a line's two sides, an imprint's walls and the sides
/// of what is in the hand do, and seldom meet.
bool takesLongSteps(Tool tool)
{
    return sharpens(tool) || tool == Tool::Stamp || isDragTool(tool);
}
} // namespace

double DabEngine::detailShare(const StrokeSettings& settings)
{
    if (settings.topology == Topology::Uniform)
        return 1;
    if (settings.tool == Tool::Stamp)
        return stampDetail;
    if (settings.alpha && usesAlpha(settings.tool))
        return alphaDetail;
    return sharpens(settings.tool) ? lineDetail : 1;
}

EdgeBounds DabEngine::boundsFor(const StrokeSettings& settings, double radius) const
{
    const double uniform = settings.detailLength > 0 ? settings.detailLength : m_mesh.uniformDetail();
    const EdgeBounds bounds = settings.topology == Topology::Uniform
                                  ? edgeBounds(uniform)
                                  : edgeBounds(radius, detailShare(settings) * settings.detail);
    return edgeBounds(std::max(bounds.detail, m_mesh.lattice().minDetail()));
}

/// The first sub-step begins with this: the mesh under the brush is made fine enough to plan on.
RemeshCounts DabEngine::refineAndPlan(Task& task, MeshEditor edit, DabReport& report)
{
    RemeshCounts counts;
    if (!m_grab.isOn) {
        const PhaseTimer timer(report.optimiseMs, m_surface.verifyMs());
        counts = refine(edit, m_region, m_candidates, task.ball, task.bounds);
    }
    if (task.settings.brush == BrushShape::Ray && counts.splits > 0) {
        const PhaseTimer timer(report.selectMs);
        selectRefined(m_region, task.ball);
        if (m_mirror.isOn())
            keepHalf(m_region, m_mirror);
    }
    const PhaseTimer timer(report.deformMs, report.fuseMs);
    report.asked = plan(task);
    if (task.canFuse && takesLongSteps(task.settings.tool) && !m_limits.inUse()) {
        const PhaseTimer fuseTimer(report.fuseMs);
        task.canFuse = m_fusion.predictContact(m_surface, m_region, grabBounds(task.settings, task.bounds));
    }
    if (!task.canFuse)
        task.bounds = grabBounds(task.settings, task.bounds);
    task.steps = std::max(1.0, std::ceil(report.asked / (movePerMinimum * task.bounds.minimum)));
    m_capped = task.steps > maxSteps;
    task.left = ticksPerStep * static_cast<unsigned>(std::min(task.steps, maxSteps));
    task.maxTicks = ticksPerStep;
    if (task.steps > 1 && !task.canFuse)
        task.maxTicks *= std::max(1u, static_cast<unsigned>(task.steps / transactionsFor(task)));
    task.ticks = std::min(task.maxTicks, task.left);
    return counts;
}

/// Into how many the plan is cut where nothing can meet: in none do neighbours move more than d_move against each
/// other, or, of what is in the hand, which folds up only where it is dragged far along the surface, more than an edge
/// is long. An imprint is done at once: what moves in one direction does not fold up, however steep its walls become.
double DabEngine::transactionsFor(const Task& task) const
{
    if (task.settings.tool == Tool::Stamp)
        return 1;
    const double max = keepsSelection(task.settings.tool) ? task.bounds.detail : movePerMinimum * task.bounds.minimum;
    return std::max(1.0, std::ceil(longestBetweenNeighbours() / max));
}

/// The longest of the differences between the plans of neighbours.
double DabEngine::longestBetweenNeighbours() const
{
    const std::vector<Slot>& slots = m_region.slots();
    std::vector<double> longest2(1 + chunksOf(slots.size(), verticesPerChunk), 0.0);
    forEachChunk(slots.size(), verticesPerChunk, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const Slot v = slots[i];
            if (!m_region.contains(v))
                continue;
            const Vec3& plan = m_region.plan(v);
            m_mesh.forEachOutgoing(v, [&](Slot h) {
                const Slot other = m_mesh.to(h);
                if (other > v && m_region.contains(other)) // at the region's rim the plan is nearly none
                    longest2[chunk] = std::max(longest2[chunk], (plan - m_region.plan(other)).squaredNorm());
            });
        }
    });
    return std::sqrt(*std::ranges::max_element(longest2));
}

/// Returns the longest displacement planned.
double DabEngine::plan(const Task& task)
{
    if (task.settings.tool == Tool::Layer)
        recallRaised();
    if (!m_mirror.isOn())
        return planDeformation(m_region, m_mesh, task.settings, task.dab);
    selectBothSides(task);
    return planMirrored(m_region, m_whole, m_mirror, m_mesh, task.settings, task.dab);
}
} // namespace core
