#pragma once

#include "core/geometry/lattice_box.h"

#include <algorithm>
#include <vector>

namespace core::repair
{
/// Triangles of a file during repair, on the lattice. Only guarantee: indices are in range.
struct TriangleSoup
{
    std::vector<LatticePoint> points;
    std::vector<Rgb> colors; ///< empty, or one per point
    std::vector<Triangle> triangles;

    /// Returns the points as doubles, in lattice units.
    std::vector<Vec3> places() const
    {
        std::vector<Vec3> places;
        places.reserve(points.size());
        for (const LatticePoint& p : points)
            places.push_back(p.cast<double>());
        return places;
    }
    LatticeBox box() const ///< bounds of the triangles
    {
        LatticeBox box;
        for (const Triangle& t : triangles) {
            for (const Slot v : t)
                box.extend(points[v]);
        }
        return box;
    }

    /// Adds a point with the mean colour of two other points, which may be the same. Returns the index of the new
    /// point.
    Slot addPoint(const LatticePoint& p, Slot colorOf, Slot otherColorOf)
    {
        points.push_back(p);
        if (!colors.empty()) {
            const Rgb a = colors[colorOf], b = colors[otherColorOf];
            const auto middle = [](std::uint8_t x, std::uint8_t y) {
                return static_cast<std::uint8_t>((x + y + 1) / 2);
            };
            colors.push_back({middle(a.r, b.r), middle(a.g, b.g), middle(a.b, b.b)});
        }
        return static_cast<Slot>(points.size() - 1);
    }
};

/// Returns the corners in ascending order: equal for all faces with the same corners, in either orientation.
inline Triangle sortedCorners(Triangle t)
{
    std::ranges::sort(t);
    return t;
}
} // namespace core::repair
