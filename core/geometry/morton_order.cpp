#include "core/geometry/morton_order.h"

#include "core/geometry/morton_code.h"
#include "core/util/radix_sort.h"

#include <algorithm>
#include <numeric>

namespace core
{
namespace
{
std::vector<Slot> vertexOrder(const TriangleMesh& mesh, const Lattice& lattice)
{
    struct MortonKey
    {
        std::uint64_t code = 0;
        Slot vertex = 0;
    };
    std::vector<MortonKey> keys(mesh.points.size());
    for (Slot v = 0; v < keys.size(); ++v)
        keys[v] = {mortonCodeOf(lattice.toLattice(mesh.points[v])), v};
    radixSort(keys, &MortonKey::code);
    const auto pointOf = [&](const MortonKey& key) {
        const LatticePoint p = lattice.toLattice(mesh.points[key.vertex]);
        return std::array{p.x(), p.y(), p.z()};
    };
    for (auto begin = keys.begin();
         begin != keys.end();) { // equal codes are ordered by lattice point: no two vertices share a point
        const auto end = std::find_if(begin, keys.end(), [&](const MortonKey& key) { return key.code != begin->code; });
        if (end - begin > 1)
            std::ranges::sort(begin, end, {}, pointOf);
        begin = end;
    }
    std::vector<Slot> order;
    order.reserve(keys.size());
    for (const MortonKey& key : keys)
        order.push_back(key.vertex);
    return order;
}

/// Returns the triangles in ascending order. A counting sort by first corner, then a sort of the few triangles of each.
std::vector<Triangle> sorted(const std::vector<Triangle>& triangles, std::size_t vertices)
{
    std::vector<Slot> ends(vertices + 1);
    for (const Triangle& t : triangles)
        ++ends[t[0] + 1];
    std::partial_sum(ends.begin(), ends.end(), ends.begin());
    std::vector<Triangle> result(triangles.size());
    for (const Triangle& t : triangles)
        result[ends[t[0]]++] = t;
    auto begin = result.begin();
    for (Slot v = 0; v < vertices; ++v) {
        const auto end = result.begin() + ends[v];
        std::sort(begin, end);
        begin = end;
    }
    return result;
}
} // namespace

std::uint64_t mortonCodeOf(const LatticePoint& p)
{
    const auto upper = [](int x) { return static_cast<std::uint64_t>(x + Lattice::limit) >> (24 - mortonBits); };
    return mortonCode({upper(p.x()), upper(p.y()), upper(p.z())});
}

TriangleMesh inMortonOrder(const TriangleMesh& mesh, const Lattice& lattice)
{
    const std::vector<Slot> order = vertexOrder(mesh, lattice);
    std::vector<Slot> newSlot(order.size());
    TriangleMesh result;
    result.points.reserve(order.size());
    for (Slot v = 0; v < order.size(); ++v) {
        newSlot[order[v]] = v;
        result.points.push_back(mesh.points[order[v]]);
        if (!mesh.colors.empty())
            result.colors.push_back(mesh.colors[order[v]]);
        if (!mesh.masks.empty())
            result.masks.push_back(mesh.masks[order[v]]);
        if (!mesh.parts.empty())
            result.parts.push_back(mesh.parts[order[v]]);
    }
    std::vector<Triangle> triangles;
    triangles.reserve(mesh.triangles.size());
    for (const Triangle& t : mesh.triangles) {
        Triangle moved = {newSlot[t[0]], newSlot[t[1]], newSlot[t[2]]};
        std::ranges::rotate(moved, std::ranges::min_element(moved));
        triangles.push_back(moved);
    }
    result.triangles = sorted(triangles, result.points.size());
    return result;
}
} // namespace core
