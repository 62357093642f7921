#pragma once

#include "core/geometry/geometry.h"

#include <algorithm>
#include <numeric>
#include <span>
#include <tuple>
#include <vector>

namespace core::repair
{
/// A face at an edge.
struct EdgeFace
{
    Slot low, high; ///< the edge's ends, low < high
    Slot face;
    bool forward; ///< the face runs along the edge from low to high

    /// Returns the corner of the face that is opposite the edge.
    Slot apex(const Triangle& t) const
    {
        return t[0] != low && t[0] != high ? t[0] : t[1] != low && t[1] != high ? t[1] : t[2];
    }
};

/// Returns the faces at all edges, grouped by edge, with faces ascending. Cost: O(faces), except at vertices with many
/// faces.
inline std::vector<EdgeFace> edgeFacesOf(std::span<const Triangle> triangles)
{
    const auto forEach = [&](auto visit) {
        for (Slot f = 0; f < triangles.size(); ++f) {
            for (std::size_t i = 0; i < 3; ++i) {
                const Slot from = triangles[f][i], to = triangles[f][i == 2 ? 0 : i + 1];
                visit(EdgeFace{std::min(from, to), std::max(from, to), f, from < to});
            }
        }
    };
    std::vector<std::size_t> end; // end of the edges of each lower vertex; their start until the second pass
    forEach([&](const EdgeFace& e) {
        if (end.size() < e.low + std::size_t(2))
            end.resize(e.low + std::size_t(2), 0);
        ++end[e.low + 1];
    });
    std::partial_sum(end.begin(), end.end(), end.begin());
    std::vector<EdgeFace> edges(3 * triangles.size());
    forEach([&](const EdgeFace& e) { edges[end[e.low]++] = e; });
    for (std::size_t begin = 0, v = 0; begin < edges.size(); begin = end[v++])
        std::sort(
            edges.begin() + static_cast<std::ptrdiff_t>(begin), edges.begin() + static_cast<std::ptrdiff_t>(end[v]),
            [](const EdgeFace& a, const EdgeFace& b) { return std::tie(a.high, a.face) < std::tie(b.high, b.face); });
    return edges;
}

/// Calls visit(faces at the edge) for each edge.
template <typename Visit> void forEachEdge(std::span<const Triangle> triangles, Visit visit)
{
    const std::vector<EdgeFace> edges = edgeFacesOf(triangles);
    for (std::size_t begin = 0, end; begin < edges.size(); begin = end) {
        end = begin;
        while (end < edges.size() && edges[end].low == edges[begin].low && edges[end].high == edges[begin].high)
            ++end;
        visit(std::span(edges).subspan(begin, end - begin));
    }
}
} // namespace core::repair
