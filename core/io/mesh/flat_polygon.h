#pragma once

#include "core/geometry/predicates.h"
#include "core/geometry/triangle_mesh.h"

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
        return m_sense * FloatPredicates::orient2d(m_points[a], m_points[b], m_points[c], m_axis);
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
