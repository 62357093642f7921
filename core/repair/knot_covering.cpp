#include "core/repair/knot_covering.h"

#include "core/geometry/box_tree.h"
#include "core/util/disjoint_sets.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

namespace core::repair
{
namespace
{
/// Adds an oblique octahedron, so that no face of the model is likely to be in its planes. It contains the ball of 0.63
/// x `radius` around `middle`.
void addSolid(TriangleSoup& surface, const LatticePoint& middle, int radius, Slot colorOf)
{
    const int r = radius, s = radius / 3;
    const auto first = static_cast<Slot>(surface.points.size());
    for (const LatticePoint& way : {LatticePoint(r, s, -s), LatticePoint(-s, r, s), LatticePoint(s, -s, r)})
        for (const int sign : {1, -1})
            surface.addPoint(middle + sign * way, colorOf, colorOf);
    for (const Triangle& t : {Triangle{0, 2, 4}, Triangle{2, 1, 4}, Triangle{1, 3, 4}, Triangle{3, 0, 4},
                              Triangle{2, 0, 5}, Triangle{1, 2, 5}, Triangle{3, 1, 5}, Triangle{0, 3, 5}})
        surface.triangles.push_back({first + t[0], first + t[1], first + t[2]});
}

/// Returns the intersection of two faces' boxes, slightly enlarged. It contains all points where the faces meet.
FaceBox commonBox(const TriangleSoup& surface, const FacePair& pair)
{
    constexpr float margin = 4;
    std::array<FaceBox, 2> boxes;
    for (std::size_t i = 0; i < 2; ++i)
        for (const Slot v : surface.triangles[i == 0 ? pair.first : pair.second])
            boxes[i].extend(surface.points[v].cast<float>().array());
    FaceBox common;
    common.min = boxes[0].min.max(boxes[1].min) - margin;
    common.max = boxes[0].max.min(boxes[1].max) + margin;
    return common;
}
} // namespace

void coverPoints(TriangleSoup& surface, std::span<const Slot> points, int radius)
{
    std::set<std::array<int, 3>> done;
    for (const Slot v : points) {
        const LatticePoint p = surface.points[v];
        if (done.insert({p.x(), p.y(), p.z()}).second)
            addSolid(surface, p, radius, v);
    }
}

CoveredKnots coverKnots(TriangleSoup& surface, std::span<const FacePair> pairs, double widest)
{
    constexpr int minRadius = 16;
    if (pairs.empty())
        return {};
    std::vector<FaceBox> boxes;
    for (const FacePair& pair : pairs)
        boxes.push_back(commonBox(surface, pair));
    DisjointSets knots(boxes.size());
    const BoxTree tree(boxes);
    for (Slot i = 0; i < boxes.size(); ++i)
        tree.forEachMeeting(boxes[i], [&](Slot position) { knots.unite(i, tree.at(position)); });
    std::map<Slot, FaceBox> boxOf; ///< box of each knot, by its first pair
    for (Slot i = 0; i < boxes.size(); ++i)
        boxOf[knots.root(i)].extend(boxes[i]);
    CoveredKnots covered;
    for (const auto& [pair, box] : boxOf) {
        const double width = std::sqrt(static_cast<double>((box.max - box.min).square().sum()));
        if (width > widest)
            continue;
        const LatticePoint middle = ((box.min + box.max) / 2).matrix().cast<int>();
        const int radius = std::max(minRadius, static_cast<int>(std::ceil(width)));
        addSolid(surface, middle, radius, surface.triangles[pairs[pair].first][0]);
        ++covered.count;
        covered.largest = std::max(covered.largest, 2.0 * radius);
    }
    return covered;
}
} // namespace core::repair
