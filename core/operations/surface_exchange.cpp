#include "core/operations/surface_exchange.h"

#include <algorithm>
#include <limits>

namespace core
{
namespace
{
/// Largest distance, in lattice units along an axis, by which combine() moves the corners of faces that it cuts: its
/// lattice has to reach around the swept solid and may be four times coarser.
constexpr int farthestMoved = 2;
} // namespace

SurfaceIndex::SurfaceIndex(const Mesh& mesh)
{
    for (const Slot v : mesh.vertices())
        m_vertices.emplace_back(placeOf(mesh.latticePoint(v)), v);
    for (const Slot f : mesh.faces())
        m_faces.emplace_back(turned(mesh.corners(f)), f);
    std::ranges::sort(m_vertices);
    std::ranges::sort(m_faces);
}

Slot SurfaceIndex::vertexNear(const Place& place, int within) const
{
    Slot nearest = noSlot;
    int least = std::numeric_limits<int>::max();
    for (int x = -within; x <= within; ++x) {
        for (int y = -within; y <= within; ++y) {
            for (int z = -within; z <= within; ++z) {
                const int away = x * x + y * y + z * z;
                if (away >= least)
                    continue;
                if (const Slot v = vertexAt({place[0] + x, place[1] + y, place[2] + z}); v != noSlot) {
                    nearest = v;
                    least = away;
                }
            }
        }
    }
    return nearest;
}

Surgery exchangeWith(const TriangleMesh& after, std::span<const LatticePoint> places, const Mesh& mesh)
{
    const SurfaceIndex index(mesh);
    Surgery surgery;
    surgery.nearby = *mesh.vertices().begin();
    std::vector<Slot> corners;
    for (std::size_t i = 0; i < places.size(); ++i) {
        const SurfaceIndex::Place place = SurfaceIndex::placeOf(places[i]);
        corners.push_back(index.vertexAt(place));
        if (corners.back() != noSlot)
            continue;
        corners.back() = Surgery::newVertex(surgery.vertices.size());
        const Rgb color = after.colors.empty() ? Rgb() : after.colors[i];
        const Slot moved = index.vertexNear(place, farthestMoved);
        const std::uint8_t mask = moved == noSlot ? std::uint8_t(0) : mesh.mask(moved);
        surgery.vertices.push_back({mesh.lattice().toPoint(places[i]), color, noSlot, mask});
    }
    std::vector<bool> isKept(mesh.slots().faces, false);
    for (const auto& [a, b, c] : after.triangles) {
        const Triangle face = {corners[a], corners[b], corners[c]};
        if (const Slot same = index.faceOf(face); same != noSlot)
            isKept[same] = true;
        else
            surgery.faces.push_back(face);
    }
    std::ranges::copy_if(mesh.faces(), std::back_inserter(surgery.removed), [&](Slot f) { return !isKept[f]; });
    return surgery;
}

bool isSymmetric(const Mesh& mesh, Symmetry plane)
{
    const auto axis = static_cast<std::size_t>(plane) - static_cast<std::size_t>(Symmetry::X);
    const SurfaceIndex index(mesh);
    const auto imageOf = [&](Slot v) {
        SurfaceIndex::Place place = SurfaceIndex::placeOf(mesh.latticePoint(v));
        place[axis] *= -1;
        return index.vertexAt(place);
    };
    return std::ranges::all_of(mesh.faces(), [&](Slot f) {
        const auto [a, b, c] = mesh.corners(f);
        return index.faceOf({imageOf(a), imageOf(c), imageOf(b)}) != noSlot;
    });
}
} // namespace core
