#include "ui/gizmo/transform_values.h"

#include <cmath>
#include <numbers>

namespace ui
{
namespace
{
using core::Vec3;

constexpr double degree = std::numbers::pi / 180;

Eigen::Quaterniond turnOf(const Vec3& degrees)
{
    const auto about = [&](int axis) { return Eigen::AngleAxisd(degrees[axis] * degree, Vec3::Unit(axis)); };
    return (about(2) * about(1) * about(0)).normalized();
}

/// Returns the inverse of turnOf(). At the poles, where Y is +-90 degrees, X is 0.
Vec3 degreesOf(const Eigen::Quaterniond& turn)
{
    const Eigen::Matrix3d m = turn.toRotationMatrix();
    const double y = std::atan2(-m(2, 0), std::hypot(m(0, 0), m(1, 0)));
    if (std::hypot(m(0, 0), m(1, 0)) < 1e-9)
        return Vec3(0, y, std::atan2(-m(0, 1), m(1, 1))) / degree;
    return Vec3(std::atan2(m(2, 1), m(2, 2)), y, std::atan2(m(1, 0), m(0, 0))) / degree;
}
} // namespace

core::Transform transformOf(const TransformValues& values, const GizmoFrame& frame)
{
    core::Transform transform;
    transform.centre = frame.centre;
    transform.by = frame.axes * values.move;
    if (!values.degrees.isZero(0))
        transform.rotation = (frame.axes * turnOf(values.degrees) * frame.axes.conjugate()).normalized();
    transform.scale = values.scale;
    if (values.scale != Vec3::Ones())
        transform.scaleAxes = frame.axes;
    return transform;
}

TransformValues valuesOf(const core::Transform& transform, const GizmoFrame& frame)
{
    return {frame.axes.conjugate() * transform.by, degreesOf(frame.axes.conjugate() * transform.rotation * frame.axes),
            transform.scale};
}
} // namespace ui
