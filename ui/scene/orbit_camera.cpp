#include "ui/scene/orbit_camera.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ui
{
namespace
{
/// half of the vertical field of view, radians; narrow, so that proportions look true
constexpr double halfFieldOfView = 0.5 * 35.0 * std::numbers::pi / 180.0;
constexpr double frameMargin = 1.05;
constexpr double minZoomDistance = 1e-3, maxZoomDistance = 40; ///< distances in radii of the scene
/// distance from the scene's centre that is visible between near and far plane, in radii of the scene
constexpr double groundReach = 6;

core::Vec3 direction(double yaw, double pitch)
{
    return -core::Vec3(std::sin(yaw) * std::cos(pitch), std::sin(pitch), std::cos(yaw) * std::cos(pitch));
}
} // namespace

void OrbitCamera::setViewport(double width, double height)
{
    m_width = std::max(width, 1.0);
    m_height = std::max(height, 1.0);
}

void OrbitCamera::setScene(const core::Box& box)
{
    if (box.isEmpty())
        return;
    m_sceneCenter = box.center();
    m_sceneRadius = std::max(0.5 * box.diagonal().norm(), 1e-6);
    if (m_pivot && (*m_pivot - m_sceneCenter).norm() > m_sceneRadius)
        m_pivot.reset();
}

void OrbitCamera::frame(const core::Box& box)
{
    const core::Box shown = box.isEmpty() ? core::Box(core::Vec3::Constant(-50), core::Vec3::Constant(50)) : box;
    setScene(shown);
    m_target = m_sceneCenter;

    // The distance at which each corner just touches one of the four sides of the view. In orthographic views a nearer
    // corner does not look larger.
    const double vertical = std::tan(halfFieldOfView);
    const double horizontal = vertical * m_width / m_height;
    double distance = 0;
    for (int i = 0; i < 8; ++i) {
        const core::Vec3 corner = shown.corner(static_cast<core::Box::CornerType>(i)) - m_target;
        const double nearer = m_projection == Projection::Perspective ? -corner.dot(viewDirection()) : 0;
        const double aside =
            std::max(std::abs(corner.dot(up())) / vertical, std::abs(corner.dot(right())) / horizontal);
        distance = std::max(distance, nearer + aside);
    }
    m_distance = std::max(distance * frameMargin, m_sceneRadius * minZoomDistance);
}

void OrbitCamera::orbit(const Pixel& delta)
{
    const double perPixel = std::numbers::pi / m_height;
    turn(m_yaw - delta.x() * perPixel, m_pitch + delta.y() * perPixel);
}

void OrbitCamera::turnToFirst()
{
    turn(firstYaw, firstPitch);
}

void OrbitCamera::turnTo(Side side)
{
    constexpr double quarter = std::numbers::pi / 2;
    constexpr double turns[][2] = {{0, 0}, {2 * quarter, 0}, {quarter, 0}, {-quarter, 0}, {0, quarter}, {0, -quarter}};
    const auto& [yaw, pitch] = turns[static_cast<std::size_t>(side)];
    turn(yaw, pitch);
}

/// Turns the camera to these angles in radians. The target turns about the pivot with the camera.
void OrbitCamera::turn(double yaw, double pitch)
{
    const core::Vec3 seen = axes().transpose() * (m_target - pivot());
    m_yaw = std::remainder(yaw, 2 * std::numbers::pi);
    m_pitch = std::clamp(pitch, -std::numbers::pi / 2, std::numbers::pi / 2);
    m_target = pivot() + axes() * seen;
}

void OrbitCamera::turnModel(double angle)
{
    m_yaw = std::remainder(m_yaw - angle, 2 * std::numbers::pi);
    m_target = Eigen::AngleAxisd(-angle, core::Vec3::UnitY()) * m_target;
}

void OrbitCamera::setTargetDepth(const core::Vec3& point)
{
    double forward = depthOf(point) - m_distance;
    if (m_projection == Projection::Perspective) {
        forward = reachable(m_distance + forward) - m_distance;
        m_distance += forward;
    }
    m_target += forward * viewDirection();
}

void OrbitCamera::pan(const Pixel& delta)
{
    const double mmPerPixel = 1 / pixelsPerMm(m_target);
    m_target += (up() * delta.y() - right() * delta.x()) * mmPerPixel;
}

void OrbitCamera::zoom(double factor, const Pixel& toward)
{
    const double distance = reachable(m_distance * factor);
    const double applied = distance / m_distance;
    const core::Ray through = ray(toward);
    const double deep = m_distance - depthOf(through.origin);
    const core::Vec3 held = through.origin + through.direction * (deep / through.direction.dot(viewDirection()));
    m_target = held + (m_target - held) * applied;
    m_distance = distance;
}

core::SavedView OrbitCamera::saved() const
{
    return {m_target, m_distance, m_yaw, m_pitch, m_projection == Projection::Orthographic};
}

void OrbitCamera::setView(const core::SavedView& view)
{
    if ((view.target - m_sceneCenter).norm() > m_sceneRadius * maxZoomDistance)
        return;
    m_pivot.reset();
    m_projection = view.orthographic ? Projection::Orthographic : Projection::Perspective;
    m_yaw = std::remainder(view.yaw, 2 * std::numbers::pi);
    m_pitch = std::clamp(view.pitch, -std::numbers::pi / 2, std::numbers::pi / 2);
    m_distance = reachable(view.distance);
    m_target = view.target;
}

double OrbitCamera::reachable(double distance) const
{
    return std::clamp(distance, m_sceneRadius * minZoomDistance, m_sceneRadius * maxZoomDistance);
}

void OrbitCamera::setPose(const Pose& pose)
{
    m_target = pose.target;
    m_distance = reachable(pose.distance);
    m_yaw = std::remainder(pose.yaw, 2 * std::numbers::pi);
    m_pitch = std::clamp(pose.pitch, -std::numbers::pi / 2, std::numbers::pi / 2);
}

OrbitCamera::Pose OrbitCamera::facing(const core::Vec3& point, const core::Vec3& normal, double extent) const
{
    constexpr double steepest = 75 * std::numbers::pi / 180, aside = 0.35;
    const bool hasYaw = std::hypot(normal.x(), normal.z()) > 1e-3 * normal.norm();
    const double pitch = std::atan2(normal.y(), std::hypot(normal.x(), normal.z()));
    const double distance = reachable(1.5 * extent / std::tan(halfFieldOfView));
    return {point, distance, hasYaw ? std::atan2(normal.x(), normal.z()) + aside : m_yaw,
            std::clamp(pitch, -steepest, steepest)};
}

OrbitCamera::Pose OrbitCamera::standing(const core::Vec3& eye, double yaw, double pitch) const
{
    const double distance = reachable((m_sceneCenter - eye).norm());
    return {eye + distance * direction(yaw, pitch), distance, yaw, pitch};
}

OrbitCamera::Pose OrbitCamera::between(const Pose& from, const Pose& to, double share)
{
    const double turn = std::remainder(to.yaw - from.yaw, 2 * std::numbers::pi);
    return {from.target + share * (to.target - from.target),
            from.distance * std::pow(to.distance / from.distance, share), from.yaw + share * turn,
            from.pitch + share * (to.pitch - from.pitch)};
}

core::Vec3 OrbitCamera::eye() const
{
    return m_target - m_distance * viewDirection();
}

core::Vec3 OrbitCamera::viewDirection() const
{
    return direction(m_yaw, m_pitch);
}

core::Vec3 OrbitCamera::right() const
{
    return {std::cos(m_yaw), 0, -std::sin(m_yaw)};
}

core::Vec3 OrbitCamera::up() const
{
    return right().cross(viewDirection());
}

Eigen::Matrix3d OrbitCamera::axes() const
{
    Eigen::Matrix3d m;
    m << right(), up(), viewDirection();
    return m;
}

core::Ray OrbitCamera::ray(const Pixel& pixel) const
{
    const double x = (2 * pixel.x() / m_width - 1) * std::tan(halfFieldOfView) * m_width / m_height;
    const double y = (1 - 2 * pixel.y() / m_height) * std::tan(halfFieldOfView);
    if (m_projection == Projection::Orthographic)
        return {eye() + m_distance * (right() * x + up() * y) + nearPlane() * viewDirection(), viewDirection()};
    return {eye(), (viewDirection() + right() * x + up() * y).normalized()};
}

core::Vec3 OrbitCamera::acrossPivot(const core::Ray& ray) const
{
    const core::Vec3 normal = viewDirection();
    const auto along = [&](const core::Vec3& point) {
        return (point - ray.origin).dot(normal) / ray.direction.dot(normal);
    };
    const double there = along(pivot());
    return ray.origin + (there > 0 ? there : along(m_target)) * ray.direction;
}

OrbitCamera::Pixel OrbitCamera::project(const core::Vec3& point) const
{
    const core::Vec3 p = point - eye();
    const double focal = 0.5 * m_height / std::tan(halfFieldOfView);
    const double depth = sizeDepth(point);
    return {0.5 * m_width + focal * p.dot(right()) / depth, 0.5 * m_height - focal * p.dot(up()) / depth};
}

double OrbitCamera::pixelsPerMm(const core::Vec3& at) const
{
    return 0.5 * m_height / (std::tan(halfFieldOfView) * std::max(sizeDepth(at), reachable(0)));
}

double OrbitCamera::depthOf(const core::Vec3& point) const
{
    return (point - eye()).dot(viewDirection());
}

/// Returns the depth that determines a point's scale in the view. In orthographic views it is the same for all points.
double OrbitCamera::sizeDepth(const core::Vec3& point) const
{
    return m_projection == Projection::Perspective ? depthOf(point) : m_distance;
}

double OrbitCamera::nearPlane() const
{
    if (m_projection == Projection::Orthographic)
        return depthOf(m_sceneCenter) - m_sceneRadius * groundReach;
    return std::max(depthOf(m_sceneCenter) - m_sceneRadius * groundReach, 0.02 * m_distance);
}

double OrbitCamera::farPlane() const
{
    return std::max(depthOf(m_sceneCenter) + m_sceneRadius * groundReach, 2 * m_distance);
}

Eigen::Matrix4d OrbitCamera::viewMatrix() const
{
    Eigen::Matrix4d m = Eigen::Matrix4d::Identity();
    m.block<1, 3>(0, 0) = right();
    m.block<1, 3>(1, 0) = up();
    m.block<1, 3>(2, 0) = -viewDirection();
    m.block<3, 1>(0, 3) = -m.block<3, 3>(0, 0) * eye();
    return m;
}

Eigen::Matrix4d OrbitCamera::projectionMatrix() const
{
    const double f = 1 / std::tan(halfFieldOfView);
    const double n = nearPlane(), r = farPlane();
    Eigen::Matrix4d m = Eigen::Matrix4d::Zero();
    m(0, 0) = f * m_height / m_width;
    m(1, 1) = f;
    if (m_projection == Projection::Orthographic) {
        m.topRows<2>() /= m_distance;
        m(2, 2) = 2 / (n - r);
        m(2, 3) = (r + n) / (n - r);
        m(3, 3) = 1;
        return m;
    }
    m(2, 2) = (r + n) / (n - r);
    m(2, 3) = 2 * r * n / (n - r);
    m(3, 2) = -1;
    return m;
}
} // namespace ui
