#include "core/sculpt/step_plan.h"

#include "core/util/parallel.h"

#include <algorithm>

namespace core
{
namespace
{
/// Largest number of sub-steps in a plan. A guard against endless work, not a tuning knob: a dab that needs more ends
/// early.
constexpr double maxSteps = 4096;
/// Vertices per parallel chunk.
constexpr std::size_t verticesPerChunk = 512;

/// Returns the longest difference between the displacements planned for two neighbours, in mm.
double longestBetweenNeighbours(const Region& region, const Mesh& mesh)
{
    const std::vector<Slot>& slots = region.slots();
    std::vector<double> longest2(1 + chunksOf(slots.size(), verticesPerChunk), 0.0);
    forEachChunk(slots.size(), verticesPerChunk, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const Slot v = slots[i];
            if (!region.contains(v))
                continue;
            const Vec3& plan = region.plan(v);
            mesh.forEachOutgoing(v, [&](Slot h) {
                const Slot other = mesh.to(h);
                // vertices outside the region are ignored: at the rim the plan is nearly zero
                if (other > v && region.contains(other))
                    longest2[chunk] = std::max(longest2[chunk], (plan - region.plan(other)).squaredNorm());
            });
        }
    });
    return std::sqrt(*std::ranges::max_element(longest2));
}

/// Returns the number of transactions that a plan needs if surfaces cannot meet. In each of them, neighbours move less
/// than d_move relative to each other. For a grabbed region the limit is d_detail, because it only folds up if it is
/// dragged far along the surface. A stamp needs one transaction: vertices that all move in one direction do not fold
/// up, however steep the walls become.
double transactionsFor(const DabContext& context)
{
    const Tool tool = context.settings.tool;
    if (tool == Tool::Stamp)
        return 1;
    const double longest = keepsSelection(tool) ? context.bounds.detail : context.bounds.move();
    return std::max(1.0, std::ceil(longestBetweenNeighbours(context.region, context.mesh()) / longest));
}
} // namespace

void StepPlan::cut(const DabContext& context)
{
    m_steps = std::max(1.0, std::ceil(context.report.asked / context.bounds.move()));
    m_ticksLeft = ticksPerStep * static_cast<unsigned>(std::min(m_steps, maxSteps));
    m_maxTicks = ticksPerStep;
    if (m_steps > 1 && !context.canFuse)
        m_maxTicks *= std::max(1u, static_cast<unsigned>(m_steps / transactionsFor(context)));
    m_ticks = std::min(m_maxTicks, m_ticksLeft);
}

bool StepPlan::isTooLong() const
{
    return m_steps > maxSteps;
}

void StepPlan::advance()
{
    m_ticksLeft -= m_ticks;
    m_retries = 0;
    m_ticks = std::min({2 * m_ticks, m_maxTicks, m_ticksLeft});
}

bool StepPlan::extend(double share)
{
    const double plan = ticksPerStep * m_steps, wanted = std::floor(share * plan),
                 allowed = std::floor(maxExtension * plan) - m_addedTicks;
    const double ticks = std::min({wanted, allowed, static_cast<double>(ticksPerStep)});
    if (ticks < 1)
        return false;
    m_ticks = m_ticksLeft = static_cast<unsigned>(ticks);
    m_addedTicks += m_ticks;
    return true;
}

bool StepPlan::halveTransaction()
{
    if (m_ticks <= ticksPerStep)
        return false;
    m_maxTicks = m_ticks = std::max(m_ticks / 2, ticksPerStep);
    return true;
}

void StepPlan::takeSingleSteps()
{
    m_maxTicks = ticksPerStep;
    m_ticks = std::min(m_maxTicks, m_ticksLeft);
}
} // namespace core
