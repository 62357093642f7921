#pragma once

#include "core/geometry/lattice_box.h"

#include <algorithm>
#include <vector>

namespace core::repair
{
/// Triangles of any file on the lattice, while they are being repaired. No promise but indices in range.
struct TriangleSoup
{
    std::vector<LatticePoint> points;
    std::vector<Rgb> colors; ///< empty, or one per point
    std::vector<Triangle> triangles;

    /// The points, in lattice units.
    std::vector<Vec3> places() const
    {
        std::vector<Vec3> places;
        places.reserve(points.size());
        for (const LatticePoint& p : points)
            places.push_back(p.cast<double>());
        return places;
    }
    LatticeBox box() const ///< of the triangles
    {
        LatticeBox box;
        for (const Triangle& t : triangles) {
            for (const Slot v : t)
                box.extend(points[v]);
        }
        return box;
    }

    /// Adds a point, coloured halfway between two others, or as one if both are the same. Returns its slot.
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

/// The corners in ascending order: the same for all faces between them, however they run.
inline Triangle sortedCorners(Triangle t)
{
    std::ranges::sort(t);
    return t;
}
} // namespace core::repair
