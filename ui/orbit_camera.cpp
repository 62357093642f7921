#include "orbit_camera.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ui
{
namespace
{
constexpr double halfFieldOfView = 0.5 * 35.0 * std::numbers::pi / 180.0; ///< vertical; narrow, for true proportions
constexpr double frameMargin = 1.05;
constexpr double nearestZoom = 1e-3, farthestZoom = 40; ///< distances, in radii of the scene
constexpr double groundReach = 6;                       ///< radii of the scene that the far plane must hold
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
}

void OrbitCamera::frame(const core::Box& box)
{
    const core::Box shown = box.isEmpty() ? core::Box(core::Vec3::Constant(-50), core::Vec3::Constant(50)) : box;
    setScene(shown);
    m_target = m_sceneCenter;

    // The distance at which each corner just touches one of the four sides of the view.
    const double vertical = std::tan(halfFieldOfView);
    const double horizontal = vertical * m_width / m_height;
    double distance = 0;
    for (int i = 0; i < 8; ++i) {
        const core::Vec3 corner = shown.corner(static_cast<core::Box::CornerType>(i)) - m_target;
        const double nearer = -corner.dot(viewDirection());
        const double aside =
            std::max(std::abs(corner.dot(up())) / vertical, std::abs(corner.dot(right())) / horizontal);
        distance = std::max(distance, nearer + aside);
    }
    m_distance = std::max(distance * frameMargin, m_sceneRadius * nearestZoom);
}

void OrbitCamera::orbit(const Pixel& delta)
{
    const double perPixel = std::numbers::pi / m_height;
    m_yaw = std::remainder(m_yaw - delta.x() * perPixel, 2 * std::numbers::pi);
    m_pitch = std::clamp(m_pitch + delta.y() * perPixel, -std::numbers::pi / 2, std::numbers::pi / 2);
}

void OrbitCamera::pan(const Pixel& delta)
{
    const double mmPerPixel = 1 / pixelsPerMm(m_target);
    m_target += (up() * delta.y() - right() * delta.x()) * mmPerPixel;
}

void OrbitCamera::zoom(double factor, const Pixel& toward)
{
    const double distance = std::clamp(m_distance * factor, m_sceneRadius * nearestZoom, m_sceneRadius * farthestZoom);
    const double applied = distance / m_distance;
    const core::Ray through = ray(toward);
    const core::Vec3 held = through.origin + through.direction * (m_distance / through.direction.dot(viewDirection()));
    m_target = held + (m_target - held) * applied;
    m_distance = distance;
}

core::Vec3 OrbitCamera::eye() const
{
    return m_target - m_distance * viewDirection();
}

core::Vec3 OrbitCamera::viewDirection() const
{
    return -core::Vec3(std::sin(m_yaw) * std::cos(m_pitch), std::sin(m_pitch), std::cos(m_yaw) * std::cos(m_pitch));
}

core::Vec3 OrbitCamera::right() const
{
    return {std::cos(m_yaw), 0, -std::sin(m_yaw)};
}

core::Vec3 OrbitCamera::up() const
{
    return right().cross(viewDirection());
}

core::Ray OrbitCamera::ray(const Pixel& pixel) const
{
    const double x = (2 * pixel.x() / m_width - 1) * std::tan(halfFieldOfView) * m_width / m_height;
    const double y = (1 - 2 * pixel.y() / m_height) * std::tan(halfFieldOfView);
    return {eye(), (viewDirection() + right() * x + up() * y).normalized()};
}

OrbitCamera::Pixel OrbitCamera::project(const core::Vec3& point) const
{
    const core::Vec3 p = point - eye();
    const double focal = 0.5 * m_height / std::tan(halfFieldOfView);
    const double depth = depthOf(point);
    return {0.5 * m_width + focal * p.dot(right()) / depth, 0.5 * m_height - focal * p.dot(up()) / depth};
}

double OrbitCamera::pixelsPerMm(const core::Vec3& at) const
{
    return 0.5 * m_height / (std::tan(halfFieldOfView) * std::max(depthOf(at), nearPlane()));
}

double OrbitCamera::depthOf(const core::Vec3& point) const
{
    return (point - eye()).dot(viewDirection());
}

double OrbitCamera::nearPlane() const
{
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
    m(2, 2) = (r + n) / (n - r);
    m(2, 3) = 2 * r * n / (n - r);
    m(3, 2) = -1;
    return m;
}
} // namespace ui
