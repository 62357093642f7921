#include "core/sculpt/remesh/edge_collapse.h"

#include "core/sculpt/remesh/collapse_placement.h"

#include <algorithm>

namespace core
{
namespace
{
/// Sine of the smallest angle that a collapse may make, 5 degrees, unless the face had a smaller one before. A larger
/// limit would block collapses that improve their surroundings.
constexpr double collapsedAngleSine = 0.0872;
/// Limits for the place of a merged vertex where the shape is kept. Its distance from the planes of the faces is the
/// root of planeError(). Up to onPlanes (in d) it counts as zero. A place is allowed if its squared distance is at most
/// littleLarger times that of the best place, plus nearPlanes squared (nearPlanes in d).
constexpr double onPlanes = 0.02, nearPlanes = 0.03, littleLarger = 1.5;
/// Share of its squared sine that an angle below collapsedAngleSine must keep in a collapse where the shape is kept.
/// Slivers around the tip of a cone must narrow a little to become fewer; otherwise the tip would be lost.
constexpr double keptOfSliver2 = 0.5;
} // namespace

EdgeCollapse::EdgeCollapse(RemeshPass& pass, bool keepsShape)
    : m_pass(pass)
    , m_mesh(pass.mesh())
    , m_keepsShape(keepsShape)
    , m_limits{collapsedAngleSine, 0, keepsShape ? keptOfSliver2 : 1}
{}

void EdgeCollapse::collapseShortEdges(std::vector<RemeshEdge> edges)
{
    while (!edges.empty())
        edges = collapse(std::move(edges));
    std::vector<VertexPair>& blocked = m_pass.counts.blocked;
    std::ranges::sort(blocked); // edges tried twice are listed twice
    blocked.erase(std::ranges::unique(blocked).begin(), blocked.end());
}

/// Collapses the edges where that is allowed, the shortest first. Returns the short edges around the collapses: they
/// have changed, or their collapse may be allowed now.
std::vector<RemeshEdge> EdgeCollapse::collapse(std::vector<RemeshEdge> edges)
{
    Region& region = m_pass.region();
    std::ranges::sort(edges, isShorter);
    SlotSet& around = region.scratch();
    around.clear();
    for (const RemeshEdge& e : edges) {
        if (!m_mesh.isEdge(e.edge) || !m_pass.isTooShort(e.edge, m_pass.length2(e.edge)) || !m_mesh.mayGo(e.edge))
            continue;
        const Slot h = m_pass.edit().collapsing(e.edge), gone = m_mesh.from(h), stays = m_mesh.to(h);
        const std::optional<Merged> merged = mergedEnds(h);
        if (!merged)
            m_pass.counts.blocked.push_back({gone, stays});
        if (!merged || !m_pass.mayGoOn() || !m_pass.edit().collapse(h, merged->point))
            continue;
        ++m_pass.counts.collapses;
        region.setPlan(stays, merged->plan);
        region.remove(gone);
        around.add(stays);
        m_mesh.forEachOutgoing(stays, [&](Slot g) { around.add(m_mesh.to(g)); });
    }
    for (Slot v : around.slots()) {
        if (m_mesh.isVertex(v))
            m_pass.changed().add(v);
    }
    edges.clear();
    m_pass.addShortEdges(around, edges);
    return edges;
}

/// Returns the vertex to which a short edge may be collapsed: at its middle or at one of its ends. No edge may grow
/// longer than d_detail.
std::optional<EdgeCollapse::Merged> EdgeCollapse::mergedEnds(Slot h) const
{
    if (!m_mesh.isCollapseOk(h))
        return std::nullopt;
    const Region& region = m_pass.region();
    const MeshEditor& edit = m_pass.edit();
    const Slot v0 = m_mesh.from(h), v1 = m_mesh.to(h);
    const Vec3 &plan0 = region.plan(v0), &plan1 = region.plan(v1);
    Choices choices = {
        {{edit.middle(h / 2), 0.5 * (plan0 + plan1)}, {m_mesh.point(v1), plan1}, {m_mesh.point(v0), plan0}}};
    const std::size_t count = m_keepsShape ? keepShape(h, choices) : choices.size();
    for (Merged merged : std::span(choices).first(count)) {
        merged.point = edit.kept(v1, merged.point);
        const Vec3 p = merged.point.cast<double>();
        if (m_pass.staysSound(v0, v1, p, m_limits) && m_pass.staysSound(v1, v0, p, m_limits))
            return merged;
    }
    return std::nullopt;
}

/// Sorts the choices by their distance from the planes of the surrounding faces. Returns how many of them are close
/// enough; 0 if the collapse would fold up a thin wall.
std::size_t EdgeCollapse::keepShape(Slot h, Choices& choices) const
{
    if (foldsUp(m_mesh, h))
        return 0;
    for (Merged& merged : choices)
        merged.error = planeError(m_mesh, h, merged.point.cast<double>()) / m_pass.minimum2();
    std::ranges::stable_sort(
        choices, {}, [](const Merged& merged) { return merged.error > onPlanes * onPlanes ? merged.error : 0; });
    const double max = littleLarger * choices[0].error + nearPlanes * nearPlanes;
    const auto end = std::ranges::find_if(choices, [&](const Merged& merged) { return merged.error > max; });
    return static_cast<std::size_t>(end - choices.begin());
}
} // namespace core
