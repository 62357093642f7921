// 1. patches   pieces joined by edges of two, in one orientation: each has one winding number in front and one behind
// 2. classify  each patch by the winding numbers at the middle of its largest piece
// 3. keep      patches with solid only behind them, and, reversed, patches with solid only in front of them

#include "core/repair/winding_solid.h"

#include "core/repair/cleanup.h"
#include "core/repair/edge_faces.h"

#include "core/util/disjoint_sets.h"
#include "core/util/parallel_progress.h"

#include <algorithm>
#include <cmath>

namespace core::repair
{
namespace
{
/// Returns the patches: sets of pieces joined by edges of two pieces.
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

/// Winding of the surface around the space on one side of a piece.
struct Side
{
    /// 1: winding number of at least Inside::least; -1: winding number below -0.5, inside out; 0: neither
    int sign = 0;
    bool isInsideOut = false; ///< winding number below -0.5 even without the part of the cavities
};

struct Sides
{
    Side before, behind;
};

/// Computes the winding numbers on both sides of a piece: those of the arranged surface and of Beside::beyond together.
class SideWindings
{
public:
    SideWindings(const TriangleSoup& original, const Beside& beside, Inside inside)
        : m_ofSurface(original.places(), original.triangles)
        , m_ofCavities(beside.cavities.places(), beside.cavities.triangles)
        , m_beyond(beside.beyond)
        , m_inside(inside)
    {}

    Sides around(const Arrangement& arrangement, Slot face) const
    {
        constexpr double half = 0.5, nearby = 1e-3; // distance of a test point from the piece, lattice units
        const auto& [corners, original, jump] = arrangement.faces[face];
        const Vec3 middle =
            (arrangement.points[corners[0]] + arrangement.points[corners[1]] + arrangement.points[corners[2]]) / 3;
        std::vector<Slot> here = arrangement.upon[original];
        here.insert(std::ranges::lower_bound(here, original), original);
        double around = m_ofSurface.at(middle, here);
        for (const WindingNumber* faces : m_beyond)
            around += faces->at(middle);
        const Vec3 normal = (arrangement.points[corners[1]] - arrangement.points[corners[0]])
                                .cross(arrangement.points[corners[2]] - arrangement.points[corners[0]])
                                .normalized();
        const auto sideOf = [&](double number, double way) {
            const int sign = number > m_inside.least - half ? 1 : number < -half ? -1 : 0;
            return Side{sign, sign < 0 && number - m_ofCavities.at(middle + way * nearby * normal) < -half};
        };
        return {sideOf(around - half * jump, 1), sideOf(around + half * jump, -1)};
    }

private:
    WindingNumber m_ofSurface, m_ofCavities;
    const std::vector<const WindingNumber*>& m_beyond;
    Inside m_inside;
};

std::vector<Sides> classifyAll(const TriangleSoup& original, const Arrangement& arrangement, Inside inside,
                               const Beside& beside, const JobControl& control)
{
    DisjointSets patches = patchesOf(arrangement);
    const std::size_t count = arrangement.faces.size();
    std::vector<Slot> largest(count, noSlot); ///< largest piece of each patch, at its root
    for (Slot f = 0; f < count; ++f) {
        Slot& best = largest[patches.root(f)];
        if (best == noSlot || areaOf(arrangement, f) > areaOf(arrangement, best))
            best = f;
    }
    std::vector<Slot> roots;
    for (Slot f = 0; f < count; ++f)
        if (largest[f] != noSlot)
            roots.push_back(f);
    const SideWindings windings(original, beside, inside);
    std::vector<Sides> sides(count);
    constexpr std::size_t patchesPerChunk = 4;
    forEachChunkWithProgress(roots.size(), patchesPerChunk, control,
                             [&](std::size_t, std::size_t begin, std::size_t end) {
                                 for (std::size_t i = begin; i < end && !control.isCancelled(); ++i)
                                     sides[roots[i]] = windings.around(arrangement, largest[roots[i]]);
                             });
    for (Slot f = 0; f < count; ++f)
        sides[f] = sides[patches.root(f)];
    return sides;
}

/// Returns the volume of the space for which `counts` is true.
template <typename Counts>
double volumeOf(const Arrangement& arrangement, const std::vector<Sides>& sides, Counts counts)
{
    double sixVolumes = 0;
    for (Slot f = 0; f < sides.size(); ++f) {
        const auto& [before, behind] = sides[f];
        const Triangle& t = arrangement.faces[f].corners;
        const double cone = arrangement.points[t[0]].dot(arrangement.points[t[1]].cross(arrangement.points[t[2]]));
        sixVolumes += (counts(behind) - counts(before)) * cone;
    }
    return sixVolumes / 6;
}
} // namespace

WindingSolid windingSolidOf(const TriangleSoup& original, const Arrangement& arrangement, Inside inside,
                            const Beside& beside, const JobControl& control)
{
    WindingSolid solid;
    TriangleSoup& surface = solid.surface;
    surface.colors = arrangement.colors;
    surface.points.reserve(arrangement.points.size());
    for (const Vec3& p : arrangement.points)
        surface.points.push_back(p.array().round().cast<int>());
    const std::vector<Sides> sides = classifyAll(original, arrangement, inside, beside, control);
    solid.volume = volumeOf(arrangement, sides, [](const Side& side) { return side.sign > 0; });
    solid.insideOutVolume = volumeOf(arrangement, sides, [](const Side& side) { return side.isInsideOut; });
    const auto isSolid = [&](const Side& side) { return side.sign > 0 || (side.sign < 0 && inside.isEitherWay); };
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
