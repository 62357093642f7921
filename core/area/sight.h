#pragma once

#include "core/area/view_area.h"

namespace core
{
/// The lines of sight of a view, and the coordinates that they give: where a line meets a plane, and the depth along
/// the view. Thread: any; the object is immutable.
class Sight
{
public:
    explicit Sight(const ViewArea& area);

    /// Returns x and y on the plane, and the depth. In perspective x and y are at depth 1; meaningless if the depth is
    /// not above 0.
    Vec3 seen(const Vec3& p) const
    {
        const Vec3 at = m_axes.transpose() * (p - m_eye);
        return m_isPerspective ? Vec3(at.x() / at.z(), at.y() / at.z(), at.z()) : at;
    }
    Vec3 placed(const Eigen::Vector2d& at, double depth) const { return m_eye + m_axes * placedAlong(at, depth); }
    bool isPerspective() const { return m_isPerspective; }
    double scaleAt(double depth) const { return m_isPerspective ? depth : 1; }
    /// Returns the way from a point to the eye, or a step against the view without one.
    Vec3 towardEye(const Vec3& p) const { return m_isPerspective ? Vec3(m_eye - p) : Vec3(-m_axes.col(2)); }

    /// Returns the corners as seen; empty if one is beside or behind the eye, or not finite.
    std::vector<Eigen::Vector2d> seenCurve(const std::vector<Vec3>& outline) const;

private:
    Vec3 placedAlong(const Eigen::Vector2d& at, double depth) const
    {
        return {at.x() * scaleAt(depth), at.y() * scaleAt(depth), depth};
    }

    bool m_isPerspective;
    Vec3 m_eye = Vec3::Zero();
    Eigen::Matrix3d m_axes; ///< right-handed; the last one is along the view
};
} // namespace core
