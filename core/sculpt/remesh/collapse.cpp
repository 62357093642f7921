// Step 2 of remesh.cpp: what is too short is collapsed.

#include "core/sculpt/remesh/remesher.h"

#include "core/sculpt/remesh/collapse_placement.h"

#include <algorithm>

namespace core
{
namespace
{
/// The smallest angle that a collapse may make, unless there was a smaller one before: 5 degrees; more would block
/// collapses that repair what surrounds them.
constexpr double collapsedAngleSine = 0.0872;
/// Where the shape is kept: a place this near to the planes around it, in d, lies on them; one this near will do if
/// there is none, and so will one whose squared distance is little larger than the least.
constexpr double onPlanes = 0.02, nearPlanes = 0.03, littleLarger = 1.5;
/// There a collapse may narrow an angle below collapsedAngleSine, in squared sines, to this: slivers around the tip of
/// a cone must narrow a hair to become fewer, and would lose the tip else.
constexpr double keptOfSliver2 = 0.5;
} // namespace

Remesher::Limits Remesher::collapseLimits() const
{
    return {collapsedAngleSine, 0, m_keepsShape ? keptOfSliver2 : 1};
}

/// Where the ends of a short edge may become one: in the middle, or at one of them. No edge grows longer than d_detail.
std::optional<Remesher::Merged> Remesher::mergedEnds(Slot h) const
{
    if (!m_mesh.isCollapseOk(h))
        return std::nullopt;
    const Slot v0 = m_mesh.from(h), v1 = m_mesh.to(h);
    const Vec3 &plan0 = m_region.plan(v0), &plan1 = m_region.plan(v1);
    Choices choices = {
        {{m_edit.middle(h / 2), 0.5 * (plan0 + plan1)}, {m_mesh.point(v1), plan1}, {m_mesh.point(v0), plan0}}};
    const std::size_t count = m_keepsShape ? keepShape(h, choices) : choices.size();
    for (Merged merged : std::span(choices).first(count)) {
        merged.point = m_edit.kept(v1, merged.point);
        const Vec3 p = merged.point.cast<double>();
        if (staysSound(v0, v1, p, collapseLimits()) && staysSound(v1, v0, p, collapseLimits()))
            return merged;
    }
    return std::nullopt;
}

/// Sorts the choices by how well they keep to the planes of the faces around. Returns how many do.
std::size_t Remesher::keepShape(Slot h, Choices& choices) const
{
    if (foldsUp(m_mesh, h))
        return 0;
    for (Merged& merged : choices)
        merged.error = planeError(m_mesh, h, merged.point.cast<double>()) / m_minimum2;
    std::ranges::stable_sort(
        choices, {}, [](const Merged& merged) { return merged.error > onPlanes * onPlanes ? merged.error : 0; });
    const double max = littleLarger * choices[0].error + nearPlanes * nearPlanes;
    const auto end = std::ranges::find_if(choices, [&](const Merged& merged) { return merged.error > max; });
    return static_cast<std::size_t>(end - choices.begin());
}

void Remesher::collapseShortEdges(std::vector<RemeshEdge> edges)
{
    while (!edges.empty())
        edges = collapse(std::move(edges));
    std::ranges::sort(counts.blocked); // those that were tried again stand there twice
    counts.blocked.erase(std::ranges::unique(counts.blocked).begin(), counts.blocked.end());
}

/// Collapses the edges that it may, the shortest first. Returns the short edges around what it did: they changed, or
/// may be collapsed now.
std::vector<RemeshEdge> Remesher::collapse(std::vector<RemeshEdge> edges)
{
    std::ranges::sort(edges, [](const RemeshEdge& a, const RemeshEdge& b) {
        return std::tie(a.length2, a.v0, a.v1) < std::tie(b.length2, b.v0, b.v1);
    });
    SlotSet& around = m_region.scratch();
    around.clear();
    for (const RemeshEdge& e : edges) {
        if (!m_mesh.isEdge(e.edge) || length2(e.edge) >= m_minimum2 || !m_mesh.mayGo(e.edge))
            continue;
        const Slot h = m_edit.collapsing(e.edge), gone = m_mesh.from(h), stays = m_mesh.to(h);
        const std::optional<Merged> merged = mergedEnds(h);
        if (!merged)
            counts.blocked.push_back({gone, stays});
        if (!merged || !mayGoOn() || !m_edit.collapse(h, merged->point))
            continue;
        ++counts.collapses;
        m_region.setPlan(stays, merged->plan);
        m_region.remove(gone);
        around.add(stays);
        m_mesh.forEachOutgoing(stays, [&](Slot g) { around.add(m_mesh.to(g)); });
    }
    for (Slot v : around.slots()) {
        if (m_mesh.isVertex(v))
            m_changed.add(v);
    }
    edges.clear();
    addShortEdges(around, edges);
    return edges;
}

/// Those with an end among the vertices.
void Remesher::addShortEdges(const SlotSet& around, std::vector<RemeshEdge>& edges) const
{
    for (Slot v : around.slots()) {
        if (!m_region.contains(v))
            continue;
        m_mesh.forEachOutgoing(v, [&](Slot h) {
            const Slot other = m_mesh.to(h);
            const bool seen = other < v && around.contains(other);
            if (!seen && m_region.contains(other) && length2(h / 2) < m_minimum2)
                edges.push_back(edgeAt(h / 2));
        });
    }
}
} // namespace core
