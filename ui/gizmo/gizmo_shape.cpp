#include "ui/gizmo/gizmo_shape.h"

#include <QPainter>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace ui
{
namespace
{
using core::Vec3;

// Distances from the centre, as fractions of GizmoShape::length.
constexpr double shaftFrom = 0.3, shaftTo = 0.9, tip = 1.1;
constexpr double boxAt = 0.62;
constexpr double planeFrom = 0.24, planeTo = 0.42;
constexpr double ringRadius = 0.78, viewRingRadius = 1.3, scaleRingRadius = 0.19, discRadius = 0.09;

constexpr double endOn = 0.2;       ///< an axis that appears shorter than this fraction has no handles
constexpr double reach = 6;         ///< pixels from a line within which it is hit
constexpr double halfBox = 5.5;     ///< pixels
constexpr double headHalfWidth = 6; ///< pixels
constexpr int ringCorners = 96;

const QColor axisColors[] = {QColor(226, 61, 70), QColor(92, 168, 40), QColor(49, 122, 236)};
const QColor neutral(238, 240, 243), casing(20, 22, 26, 150), highlight(255, 196, 40);

double distance(const QPointF& p, const QPointF& a, const QPointF& b)
{
    const QPointF along = b - a, to = p - a;
    const double squared = QPointF::dotProduct(along, along);
    const double share = squared > 0 ? std::clamp(QPointF::dotProduct(to, along) / squared, 0.0, 1.0) : 0;
    const QPointF away = to - share * along;
    return std::hypot(away.x(), away.y());
}

double distance(const QPointF& p, const QPolygonF& line)
{
    double least = std::numeric_limits<double>::infinity();
    for (qsizetype i = 1; i < line.size(); ++i)
        least = std::min(least, distance(p, line[i - 1], line[i]));
    return least;
}

GizmoHandle handleOf(GizmoHandle first, int axis)
{
    return static_cast<GizmoHandle>(static_cast<int>(first) + axis);
}
} // namespace

GizmoShape::GizmoShape(const OrbitCamera& camera, const GizmoFrame& frame, Handles handles)
    : m_camera(camera)
    , m_frame(frame)
{
    const bool isPerspective = camera.projection() == OrbitCamera::Projection::Perspective;
    if (isPerspective && (frame.centre - camera.eye()).dot(camera.viewDirection()) <= camera.nearPlane())
        return;
    m_mm = 1 / camera.pixelsPerMm(frame.centre);
    m_centre = pixel(frame.centre);
    addCircle(GizmoHandle::TurnView, viewRingRadius, false);
    for (int axis = 0; axis < 3; ++axis)
        addRing(axis);
    for (int axis = 0; axis < 3; ++axis)
        addPlane(axis);
    // Axes that point away from the eye are drawn first.
    std::array<int, 3> order = {0, 1, 2};
    std::ranges::sort(order, std::greater(), [&](int axis) { return frame.axis(axis).dot(camera.viewDirection()); });
    for (const int axis : order) {
        if (isEndOn(axis))
            continue;
        addArrow(axis);
        if (handles == Handles::All)
            addScale(axis);
    }
    if (handles == Handles::All)
        addCircle(GizmoHandle::ScaleAll, scaleRingRadius, false);
    addCircle(GizmoHandle::MoveView, discRadius, true);
}

QPointF GizmoShape::pixel(const Vec3& point) const
{
    const OrbitCamera::Pixel at = m_camera.project(point);
    return {at.x(), at.y()};
}

bool GizmoShape::isEndOn(int axis) const
{
    const QPointF end = pixel(m_frame.centre + length * m_mm * m_frame.axis(axis)) - m_centre;
    return std::hypot(end.x(), end.y()) < endOn * length;
}

void GizmoShape::addCircle(GizmoHandle handle, double radius, bool isFilled)
{
    QPolygonF points;
    for (int i = 0; i <= ringCorners; ++i) {
        const double angle = 2 * std::numbers::pi * i / ringCorners;
        points << m_centre + radius * length * QPointF(std::cos(angle), std::sin(angle));
    }
    m_strokes.push_back({handle, points, neutral, isFilled});
}

/// Adds the half of the ring about an axis that faces the eye, or the whole ring if all of it does.
void GizmoShape::addRing(int axis)
{
    const Vec3 a = m_frame.axis((axis + 1) % 3), b = m_frame.axis((axis + 2) % 3);
    const auto arm = [&](int i) {
        const double angle = 2 * std::numbers::pi * i / ringCorners;
        return Vec3(ringRadius * length * m_mm * (std::cos(angle) * a + std::sin(angle) * b));
    };
    constexpr double facing = 0.1; // a ring that lies across the view is seen whole
    const double limit = facing * ringRadius * length * m_mm;
    const auto isFront = [&](int i) { return arm(i).dot(m_camera.viewDirection()) <= limit; };
    int first = 0; // of the visible arc
    while (first < ringCorners && !(isFront(first) && !isFront(first + ringCorners - 1)))
        ++first;
    QPolygonF points;
    for (int i = first; i <= first + ringCorners && isFront(i); ++i)
        points << pixel(m_frame.centre + arm(i));
    if (points.size() > 1)
        m_strokes.push_back({handleOf(GizmoHandle::TurnX, axis), points, axisColors[axis], false});
}

/// Adds the square in the plane whose normal is the axis, unless the plane is seen from its edge.
void GizmoShape::addPlane(int axis)
{
    if (std::abs(m_frame.axis(axis).dot(m_camera.viewDirection())) < endOn)
        return;
    const double from = planeFrom * length * m_mm, to = planeTo * length * m_mm;
    const Vec3 a = m_frame.axis((axis + 1) % 3), b = m_frame.axis((axis + 2) % 3);
    QPolygonF points;
    for (const auto& [x, y] : {std::pair(from, from), {to, from}, {to, to}, {from, to}})
        points << pixel(m_frame.centre + x * a + y * b);
    m_strokes.push_back({handleOf(GizmoHandle::MoveYZ, axis), points, axisColors[axis], true});
}

void GizmoShape::addArrow(int axis)
{
    const GizmoHandle handle = handleOf(GizmoHandle::MoveX, axis);
    const auto at = [&](double share) { return pixel(m_frame.centre + share * length * m_mm * m_frame.axis(axis)); };
    const QPointF base = at(shaftTo), end = at(tip);
    const QPointF along = (end - base) / std::max(std::hypot((end - base).x(), (end - base).y()), 1e-9);
    const QPointF across = headHalfWidth * QPointF(-along.y(), along.x());
    m_strokes.push_back({handle, QPolygonF{at(shaftFrom), base}, axisColors[axis], false});
    m_strokes.push_back({handle, QPolygonF{base - across, base + across, end}, axisColors[axis], true});
}

void GizmoShape::addScale(int axis)
{
    const QPointF at = pixel(m_frame.centre + boxAt * length * m_mm * m_frame.axis(axis));
    const QRectF box(at - QPointF(halfBox, halfBox), at + QPointF(halfBox, halfBox));
    m_strokes.push_back({handleOf(GizmoHandle::ScaleX, axis), QPolygonF(box), axisColors[axis], true});
}

std::optional<GizmoHandle> GizmoShape::handleAt(const QPointF& point) const
{
    const auto isHit = [&](const Stroke& stroke) {
        if (stroke.isFilled && stroke.points.containsPoint(point, Qt::WindingFill))
            return true;
        return distance(point, stroke.points) < (stroke.isFilled ? reach / 2 : reach);
    };
    const auto found = std::find_if(m_strokes.rbegin(), m_strokes.rend(), isHit);
    return found == m_strokes.rend() ? std::nullopt : std::optional(found->handle);
}

/// Draws every handle with a dark edge, so that it is seen on every material.
void GizmoShape::paint(QPainter& painter, std::optional<GizmoHandle> hot, std::optional<GizmoHandle> only) const
{
    const auto pen = [](const QColor& color, double width) {
        return QPen(color, width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin);
    };
    painter.setRenderHint(QPainter::Antialiasing);
    for (const Stroke& stroke : m_strokes) {
        if (only && stroke.handle != *only)
            continue;
        const bool isHot = hot == stroke.handle;
        const bool isPlane = motionOf(stroke.handle) == GizmoMotion::MoveInPlane && axisOf(stroke.handle) >= 0;
        QColor color = isHot ? highlight : stroke.color;
        if (isPlane)
            color.setAlpha(190);
        if (stroke.isFilled) {
            painter.setPen(pen(casing, 1.2));
            painter.setBrush(color);
            painter.drawPolygon(stroke.points);
            continue;
        }
        const double width = isHot ? 3.4 : stroke.handle == GizmoHandle::TurnView ? 1.6 : 2.4;
        painter.setBrush(Qt::NoBrush);
        painter.setPen(pen(casing, width + 1.6));
        painter.drawPolyline(stroke.points);
        painter.setPen(pen(color, width));
        painter.drawPolyline(stroke.points);
    }
}
} // namespace ui
