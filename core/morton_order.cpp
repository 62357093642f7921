#include "morton_order.h"

#include "morton_code.h"

#include <algorithm>
#include <numeric>

namespace core
{
namespace
{
std::vector<Slot> vertexOrder(const TriangleMesh& mesh, const Lattice& lattice)
{
    struct Key
    {
        std::uint64_t code;
        LatticePoint point; ///< decides between equal codes; two vertices never share a point
        Slot vertex;
    };
    std::vector<Key> keys;
    keys.reserve(mesh.points.size());
    for (Slot v = 0; v < mesh.points.size(); ++v) {
        const LatticePoint p = lattice.toLattice(mesh.points[v]);
        keys.push_back({mortonCodeOf(p), p, v});
    }
    std::ranges::sort(keys, [](const Key& a, const Key& b) {
        return std::tie(a.code, a.point.x(), a.point.y(), a.point.z()) <
               std::tie(b.code, b.point.x(), b.point.y(), b.point.z());
    });
    std::vector<Slot> order;
    order.reserve(keys.size());
    for (const Key& key : keys)
        order.push_back(key.vertex);
    return order;
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
    }
    result.triangles.reserve(mesh.triangles.size());
    for (const Triangle& t : mesh.triangles) {
        Triangle moved = {newSlot[t[0]], newSlot[t[1]], newSlot[t[2]]};
        std::ranges::rotate(moved, std::ranges::min_element(moved));
        result.triangles.push_back(moved);
    }
    std::ranges::sort(result.triangles);
    return result;
}
} // namespace core
