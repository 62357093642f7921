#include "ui/gizmo/gizmo_drag.h"

#include "ui/gizmo/gizmo_shape.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ui
{
namespace
{
using core::Vec3;

constexpr double minStep = 8;   ///< pixels of a move with snapping
constexpr double turnStep = 15; ///< degrees
constexpr double scaleStep = 0.1;
constexpr double minScale = 0.01, maxScale = 100;
constexpr double seenAcross = 0.25; ///< cosine below which a ring counts as seen from its edge

double rounded(double value, double step)
{
    return step * std::round(value / step);
}
} // namespace

double roundStep(double length)
{
    const double power = std::pow(10, std::floor(std::log10(length)));
    for (const double factor : {1.0, 2.0, 5.0}) {
        if (factor * power >= length * (1 - 1e-9))
            return factor * power;
    }
    return 10 * power;
}

GizmoDrag::GizmoDrag(const OrbitCamera& camera, const GizmoFrame& frame, GizmoHandle handle, const QPointF& from)
    : m_camera(camera)
    , m_frame(frame)
    , m_first(handle)
    , m_handle(handle)
    , m_from(from)
    , m_lastDirection(directionOf(from))
{}

void GizmoDrag::lockTo(int axis)
{
    GizmoHandle locked = GizmoHandle::MoveX;
    switch (motionOf(m_first)) {
    case GizmoMotion::Move:
    case GizmoMotion::MoveInPlane:
        break;
    case GizmoMotion::Turn:
        locked = GizmoHandle::TurnX;
        break;
    case GizmoMotion::Scale:
        locked = GizmoHandle::ScaleX;
        break;
    }
    locked = static_cast<GizmoHandle>(static_cast<int>(locked) + axis);
    m_handle = m_handle == locked ? m_first : locked;
    m_angle = 0;
    m_lastDirection = directionOf(m_from);
}

core::Transform GizmoDrag::to(const QPointF& pointer, bool snaps)
{
    core::Transform transform;
    transform.centre = m_frame.centre;
    switch (motionOf(m_handle)) {
    case GizmoMotion::Move:
    case GizmoMotion::MoveInPlane: {
        Vec3 by = m_frame.axes.conjugate() * moved(pointer);
        const double step = roundStep(minStep / m_camera.pixelsPerMm(m_frame.centre));
        if (snaps)
            by = by.unaryExpr([step](double x) { return rounded(x, step); });
        transform.by = m_frame.axes * by;
        break;
    }
    case GizmoMotion::Turn: {
        constexpr double degrees = 180 / std::numbers::pi;
        const double angle = turned(pointer);
        transform.rotation =
            Eigen::AngleAxisd(snaps ? rounded(angle * degrees, turnStep) / degrees : angle, turnAxis());
        break;
    }
    case GizmoMotion::Scale: {
        const double factor = snaps ? std::max(rounded(scaled(pointer), scaleStep), scaleStep) : scaled(pointer);
        transform.scaleAxes = m_frame.axes;
        if (m_handle == GizmoHandle::ScaleAll)
            transform.scale = Vec3::Constant(factor);
        else
            transform.scale[axisOf(m_handle)] = factor;
        break;
    }
    }
    return transform;
}

Vec3 GizmoDrag::moved(const QPointF& pointer) const
{
    const int axis = axisOf(m_handle);
    if (motionOf(m_handle) == GizmoMotion::Move) {
        const Vec3 along = m_frame.axis(axis);
        return (alongAxis(pointer, along) - alongAxis(m_from, along)) * along;
    }
    const Vec3 normal = axis < 0 ? m_camera.viewDirection() : m_frame.axis(axis);
    return inPlane(pointer, normal) - inPlane(m_from, normal);
}

/// Returns the coordinate on the axis, from the centre, of its point nearest to the pixel's ray, mm.
double GizmoDrag::alongAxis(const QPointF& pointer, const Vec3& axis) const
{
    const core::Ray ray = m_camera.ray({pointer.x(), pointer.y()});
    const Vec3 across = axis.cross(ray.direction).cross(ray.direction); // in the ray's normal plane
    const double slant = across.dot(axis);
    return std::abs(slant) < 1e-6 ? 0 : across.dot(ray.origin - m_frame.centre) / slant;
}

/// Returns where the pixel's ray meets the plane through the centre, relative to it; zero if they are parallel.
Vec3 GizmoDrag::inPlane(const QPointF& pointer, const Vec3& normal) const
{
    const core::Ray ray = m_camera.ray({pointer.x(), pointer.y()});
    const double slant = ray.direction.dot(normal);
    if (std::abs(slant) < 1e-3)
        return Vec3::Zero();
    const Vec3 from = ray.origin - m_frame.centre;
    return from - from.dot(normal) / slant * ray.direction;
}

Vec3 GizmoDrag::turnAxis() const
{
    const int axis = axisOf(m_handle);
    return axis < 0 ? Vec3(-m_camera.viewDirection()) : m_frame.axis(axis);
}

/// Returns the direction of the pointer about the axis of the turn, radians. Where the ring is seen from its edge, that
/// of a wheel whose rim follows the pointer.
double GizmoDrag::directionOf(const QPointF& pointer) const
{
    const Vec3 axis = turnAxis();
    if (motionOf(m_handle) != GizmoMotion::Turn)
        return 0;
    if (std::abs(axis.dot(m_camera.viewDirection())) >= seenAcross) {
        const Vec3 a = axis.unitOrthogonal(), b = axis.cross(a), at = inPlane(pointer, axis);
        return std::atan2(at.dot(b), at.dot(a));
    }
    const Vec3 rim = (-axis).cross(m_camera.viewDirection()).normalized(); // way of the nearest point of the rim
    const QPointF by = pointer - m_from;
    return (by.x() * rim.dot(m_camera.right()) - by.y() * rim.dot(m_camera.up())) / (0.8 * GizmoShape::length);
}

/// Returns the angle turned so far, which counts whole turns: no call may be half a turn from the one before.
double GizmoDrag::turned(const QPointF& pointer)
{
    const double direction = directionOf(pointer);
    m_angle += std::remainder(direction - m_lastDirection, 2 * std::numbers::pi);
    m_lastDirection = direction;
    return m_angle;
}

double GizmoDrag::scaled(const QPointF& pointer) const
{
    const int axis = axisOf(m_handle);
    if (axis >= 0 && m_handle == m_first) {
        const double from = alongAxis(m_from, m_frame.axis(axis)), to = alongAxis(pointer, m_frame.axis(axis));
        return std::abs(from) < 1e-9 ? 1 : std::clamp(to / from, minScale, maxScale);
    }
    const OrbitCamera::Pixel centre = m_camera.project(m_frame.centre);
    const auto away = [&](const QPointF& p) { return std::hypot(p.x() - centre.x(), p.y() - centre.y()); };
    return std::clamp(std::exp((away(pointer) - away(m_from)) / GizmoShape::length), minScale, maxScale);
}
} // namespace ui
