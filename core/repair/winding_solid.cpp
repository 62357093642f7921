// 1. patches   pieces joined by edges of two, in one orientation: each has one winding number before and one behind
// 2. classify  each patch by the winding numbers at the middle of its largest piece
// 3. keep      those with the inside behind, and turned over those with the inside before them

#include "core/repair/winding_solid.h"

#include "core/repair/cleanup.h"
#include "core/repair/edge_faces.h"

#include "core/geometry/winding_number.h"
#include "core/util/disjoint_sets.h"
#include "core/util/parallel_progress.h"

#include <algorithm>
#include <cmath>

namespace core::repair
{
namespace
{
/// Pieces joined by edges of two.
DisjointSets patchesOf(const Arrangement& arrangement)
{
    DisjointSets patches(arrangement.faces.size());
    std::vector<Triangle> triangles;
    triangles.reserve(arrangement.faces.size());
    for (const ArrangedFace& face : arrangement.faces)
        triangles.push_back(face.corners);
    forEachEdge(triangles, [&](std::span<const EdgeFace> around) {
        if (around.size() == 2 && around[0].forward != around[1].forward &&
            arrangement.faces[around[0].face].jump == arrangement.faces[around[1].face].jump)
            patches.unite(around[0].face, around[1].face);
    });
    return patches;
}

double areaOf(const Arrangement& arrangement, Slot face)
{
    const Triangle& t = arrangement.faces[face].corners;
    const Vec3& a = arrangement.points[t[0]];
    return (arrangement.points[t[1]] - a).cross(arrangement.points[t[2]] - a).norm();
}

/// What the space around a piece is wound around: more than a half is inside, less than minus a half inside out.
struct Sides
{
    int before = 0, behind = 0; ///< -1, 0, 1
};

Sides classify(const Arrangement& arrangement, const WindingNumber& winding, Slot face)
{
    const auto& [corners, original, jump] = arrangement.faces[face];
    const Vec3 middle =
        (arrangement.points[corners[0]] + arrangement.points[corners[1]] + arrangement.points[corners[2]]) / 3;
    std::vector<Slot> here = arrangement.upon[original];
    here.insert(std::ranges::lower_bound(here, original), original);
    const double around = winding.at(middle, here);
    const auto sign = [](double number) { return number > 0.5 ? 1 : number < -0.5 ? -1 : 0; };
    return {sign(around - 0.5 * jump), sign(around + 0.5 * jump)};
}

std::vector<Sides> classifyAll(const TriangleSoup& original, const Arrangement& arrangement, const JobControl& control)
{
    DisjointSets patches = patchesOf(arrangement);
    const std::size_t count = arrangement.faces.size();
    std::vector<Slot> largest(count, noSlot); ///< of each patch, at its root
    for (Slot f = 0; f < count; ++f) {
        Slot& best = largest[patches.root(f)];
        if (best == noSlot || areaOf(arrangement, f) > areaOf(arrangement, best))
            best = f;
    }
    std::vector<Slot> roots;
    for (Slot f = 0; f < count; ++f)
        if (largest[f] != noSlot)
            roots.push_back(f);
    const std::vector<Vec3> points = original.places();
    const WindingNumber winding(points, original.triangles);
    std::vector<Sides> sides(count);
    constexpr std::size_t patchesPerChunk = 4;
    forEachChunkWithProgress(roots.size(), patchesPerChunk, control,
                             [&](std::size_t, std::size_t begin, std::size_t end) {
                                 for (std::size_t i = begin; i < end && !control.isCancelled(); ++i)
                                     sides[roots[i]] = classify(arrangement, winding, largest[roots[i]]);
                             });
    for (Slot f = 0; f < count; ++f)
        sides[f] = sides[patches.root(f)];
    return sides;
}

/// Sums volumes, each counted as often as `weightOf` says of the winding number there.
template <typename Weight>
double volumeOf(const Arrangement& arrangement, const std::vector<Sides>& sides, Weight weightOf)
{
    double sixVolumes = 0;
    for (Slot f = 0; f < sides.size(); ++f) {
        const auto [before, behind] = sides[f];
        const Triangle& t = arrangement.faces[f].corners;
        const double cone = arrangement.points[t[0]].dot(arrangement.points[t[1]].cross(arrangement.points[t[2]]));
        sixVolumes += (weightOf(behind) - weightOf(before)) * cone;
    }
    return sixVolumes / 6;
}
} // namespace

WindingSolid windingSolidOf(const TriangleSoup& original, const Arrangement& arrangement, Inside inside,
                            const JobControl& control)
{
    WindingSolid solid;
    TriangleSoup& surface = solid.surface;
    surface.colors = arrangement.colors;
    surface.points.reserve(arrangement.points.size());
    for (const Vec3& p : arrangement.points)
        surface.points.push_back(p.array().round().cast<int>());
    const std::vector<Sides> sides = classifyAll(original, arrangement, control);
    solid.volume = volumeOf(arrangement, sides, [](int side) { return std::max(0, side); });
    solid.insideOutVolume = volumeOf(arrangement, sides, [](int side) { return std::max(0, -side); });
    const auto isSolid = [&](int side) { return side > 0 || (side < 0 && inside == Inside::NonZero); };
    for (Slot f = 0; f < sides.size(); ++f) {
        const bool before = isSolid(sides[f].before), behind = isSolid(sides[f].behind);
        const Triangle& t = arrangement.faces[f].corners;
        if (before != behind)
            surface.triangles.push_back(behind ? t : Triangle{t[0], t[2], t[1]});
    }
    weld(surface);
    return solid;
}
} // namespace core::repair
