#include "ui/shapes/tube_handles.h"

#include <QLineF>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace ui
{
namespace
{
constexpr double dotRadius = 4.5, reach = 9; ///< pixels: size of a dot, and how near the pointer must be to a handle
constexpr double minRim = 14;                ///< pixels; a smaller circle is drawn and hit with this size
constexpr QColor lightLine(255, 246, 232), darkLine(0, 0, 0, 120), chosenFill(255, 176, 60), hotFill(120, 190, 255);
} // namespace

bool TubeHandles::isShown(std::size_t point) const
{
    return m_camera.projection() == OrbitCamera::Projection::Orthographic ||
           (m_path[point].position - m_camera.eye()).dot(m_camera.viewDirection()) > m_camera.nearPlane();
}

QPointF TubeHandles::positionOf(std::size_t point) const
{
    const OrbitCamera::Pixel at = m_camera.project(m_path[point].position);
    return {at.x(), at.y()};
}

double TubeHandles::radiusInPixels(std::size_t point) const
{
    return std::max(minRim, m_path[point].radius * m_camera.pixelsPerMm(m_path[point].position));
}

std::optional<TubeHandle> TubeHandles::handleAt(const QPointF& at) const
{
    std::optional<TubeHandle> nearest;
    for (const bool isRim : {false, true}) {
        double least = isRim ? reach / 2 : reach;
        for (std::size_t i = 0; i < m_path.size() && !(isRim && nearest && !nearest->isRim); ++i) {
            const double away = std::abs(QLineF(positionOf(i), at).length() - (isRim ? radiusInPixels(i) : 0));
            if (!isShown(i) || away > least)
                continue;
            least = away;
            nearest = TubeHandle{i, isRim};
        }
    }
    return nearest;
}

std::optional<std::pair<std::size_t, core::TubePoint>> TubeHandles::insertionAt(const QPointF& at) const
{
    for (std::size_t i = 0; i + 1 < m_path.size(); ++i) {
        if (!isShown(i) || !isShown(i + 1))
            continue;
        const QPointF from = positionOf(i), way = positionOf(i + 1) - from;
        const double share = QPointF::dotProduct(at - from, way) / std::max(1.0, QPointF::dotProduct(way, way));
        if (share <= 0 || share >= 1 || QLineF(from + share * way, at).length() > reach)
            continue;
        const core::TubePoint &a = m_path[i], &b = m_path[i + 1];
        return std::pair(i + 1, core::TubePoint{a.position + share * (b.position - a.position),
                                                a.radius + share * (b.radius - a.radius)});
    }
    return std::nullopt;
}

core::Vec3 TubeHandles::placeAt(const QPointF& at, std::size_t point) const
{
    const core::Ray ray = m_camera.ray({at.x(), at.y()});
    const core::Vec3 ahead = m_camera.viewDirection();
    const double way = (m_path[point].position - ray.origin).dot(ahead) / ray.direction.dot(ahead);
    return ray.origin + way * ray.direction;
}

double TubeHandles::radiusAt(const QPointF& at, std::size_t point) const
{
    return QLineF(positionOf(point), at).length() / m_camera.pixelsPerMm(m_path[point].position);
}

void TubeHandles::paint(QPainter& painter, std::optional<std::size_t> chosen,
                        const std::optional<TubeHandle>& hot) const
{
    painter.setRenderHint(QPainter::Antialiasing);
    const auto draw = [&](const QPointF& centre, double radius, const QBrush& fill, double width) {
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(darkLine, width + 1.8));
        painter.drawEllipse(centre, radius, radius);
        painter.setBrush(fill);
        painter.setPen(QPen(lightLine, width));
        painter.drawEllipse(centre, radius, radius);
    };
    for (std::size_t i = 0; i < m_path.size(); ++i) {
        if (!isShown(i))
            continue;
        const QPointF centre = positionOf(i);
        const bool isChosen = chosen == i;
        if (isChosen || hot == TubeHandle{i, true} || hot == TubeHandle{i, false})
            draw(centre, radiusInPixels(i), Qt::NoBrush, hot == TubeHandle{i, true} ? 2.2 : 1.2);
        draw(centre, dotRadius, hot == TubeHandle{i, false} ? hotFill : isChosen ? chosenFill : lightLine, 1.2);
    }
}
} // namespace ui
