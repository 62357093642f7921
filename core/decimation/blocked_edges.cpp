#include "core/decimation/blocked_edges.h"

#include <algorithm>
#include <limits>

namespace core
{
bool BlockedEdges::isBlocked(Slot v0, Slot v1) const
{
    const auto found = m_edges.find(keyOf(v0, v1));
    return found != m_edges.end() && changesAround(found->second, v0, v1) == found->second.changes;
}

void BlockedEdges::note(const std::vector<Slot>& badFaces, Slot v0, Slot v1)
{
    const auto isBeside = [&](Slot f) {
        if (!m_mesh.isFace(f))
            return false;
        const Triangle& t = m_mesh.corners(f);
        return std::ranges::none_of(t, [&](Slot v) { return v == v0 || v == v1; });
    };
    const auto found = std::ranges::find_if(badFaces, isBeside);
    if (found != badFaces.end() && m_present.count < m_present.faces.size())
        m_present.faces[m_present.count++] = *found;
}

void BlockedEdges::keep(Slot v0, Slot v1)
{
    if (m_present.count == 0)
        return;
    m_present.changes = changesAround(m_present, v0, v1);
    m_edges[keyOf(v0, v1)] = m_present;
}

/// Sums the stamps of the vertices around the edge and of the corners of the faces in the way.
std::uint64_t BlockedEdges::changesAround(const Obstacle& obstacle, Slot v0, Slot v1) const
{
    std::uint64_t changes = 0;
    for (const Slot v : {v0, v1})
        m_mesh.forEachOutgoing(v, [&](Slot h) { changes += m_stamps[m_mesh.to(h)]; });
    for (std::size_t i = 0; i < obstacle.count; ++i) {
        if (!m_mesh.isFace(obstacle.faces[i]))
            return std::numeric_limits<std::uint64_t>::max();
        for (const Slot v : m_mesh.corners(obstacle.faces[i]))
            changes += m_stamps[v];
    }
    return changes;
}
} // namespace core
