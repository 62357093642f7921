#pragma once

#include "core/geometry/predicates.h"
#include "core/geometry/triangle_mesh.h"

#include <algorithm>
#include <array>
#include <span>

namespace core::io
{
/// A polygon projected along the axis in which its area is largest.
class FlatPolygon
{
public:
    FlatPolygon(const std::vector<Vec3f>& points, std::span<const Slot> corners) : m_points(points)
    {
        Vec3 area = Vec3::Zero();
        const Vec3 origin = point(corners[0]);
        for (std::size_t i = 1; i + 1 < corners.size(); ++i)
            area += (point(corners[i]) - origin).cross(point(corners[i + 1]) - origin);
        area.cwiseAbs().maxCoeff(&m_axis);
        m_sense = area[m_axis] < 0 ? -1 : 1;
    }

    /// Returns 1 if the path a, b, c turns in the polygon's direction, -1 if it turns against it, 0 if it is straight.
    /// Exact.
    int turn(Slot a, Slot b, Slot c) const
    {
        const bool isTold = a == b || b == c || c == a; // the predicate would need its slow, exact path
        return isTold ? 0 : m_sense * FloatPredicates::orient2d(m_points[a], m_points[b], m_points[c], m_axis);
    }

    /// Returns whether a box of projected coordinates is strictly to the right of the line from a to b, if the polygon
    /// is seen anticlockwise. Exact.
    bool isRightOf(Slot a, Slot b, const std::array<float, 2>& min, const std::array<float, 2>& max) const
    {
        // the corner of the box that is furthest to the left
        const auto along = [&](int which) {
            return m_sense > 0 ? seen(b, which) >= seen(a, which) : seen(b, which) < seen(a, which);
        };
        Vec3f corner = m_points[a];
        corner[(m_axis + 1) % 3] = along(1) ? min[0] : max[0];
        corner[(m_axis + 2) % 3] = along(0) ? max[1] : min[1];
        return m_sense * FloatPredicates::orient2d(m_points[a], m_points[b], corner, m_axis) < 0;
    }

    /// Returns whether two corners have the same projection.
    bool areSame(Slot a, Slot b) const { return seen(a, 0) == seen(b, 0) && seen(a, 1) == seen(b, 1); }

    /// Returns whether b is between a and c. Precondition: their projections are on a line.
    bool isBetween(Slot a, Slot b, Slot c) const
    {
        const auto isIn = [&](int which) {
            const float x = seen(a, which), y = seen(b, which), z = seen(c, which);
            return std::min(x, z) <= y && y <= std::max(x, z);
        };
        return isIn(0) && isIn(1);
    }

    double squaredDistance(Slot a, Slot b) const { return (point(a) - point(b)).squaredNorm(); }
    /// Returns one of the two projected coordinates. `which`: 0 or 1.
    float seen(Slot corner, int which) const { return m_points[corner][(m_axis + 1 + which) % 3]; }

private:
    Vec3 point(Slot corner) const { return m_points[corner].cast<double>(); }

    const std::vector<Vec3f>& m_points;
    int m_axis = 0;
    int m_sense = 1; ///< 1 if the projected polygon is anticlockwise, else -1
};
} // namespace core::io
