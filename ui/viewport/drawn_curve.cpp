#include "ui/viewport/drawn_curve.h"

#include "core/stroke/drawn_path.h"

#include <QLineF>
#include <QRectF>

#include <algorithm>
#include <cmath>
#include <vector>

namespace ui
{
namespace
{
constexpr double tolerance = 1; ///< pixels
/// Distance by which a line's curve reaches beyond the view, in views.
constexpr double viewsBeyond = 3;

/// Returns the part of a rectangle on the right of a line; y is down.
QPolygonF partOnTheRight(const QRectF& rectangle, const QLineF& line)
{
    const QPolygonF corners(
        {rectangle.topLeft(), rectangle.topRight(), rectangle.bottomRight(), rectangle.bottomLeft()});
    const auto side = [&](const QPointF& p) {
        return line.dx() * (p.y() - line.y1()) - line.dy() * (p.x() - line.x1());
    };
    QPolygonF part;
    for (qsizetype i = 0; i < corners.size(); ++i) {
        const QPointF p = corners[i], q = corners[(i + 1) % corners.size()];
        const double atP = side(p), atQ = side(q);
        if (atP >= 0)
            part << p;
        if ((atP >= 0) != (atQ >= 0))
            part << p + atP / (atP - atQ) * (q - p);
    }
    return part;
}
} // namespace

QPolygonF curveBetween(CurveShape shape, const QPointF& from, const QPointF& to, const QSizeF& view)
{
    if (shape == CurveShape::Box) {
        const QRectF box = QRectF(from, to).normalized();
        return box.isEmpty() ? QPolygonF()
                             : QPolygonF({box.topLeft(), box.topRight(), box.bottomRight(), box.bottomLeft()});
    }
    const double beyond = viewsBeyond * std::max(view.width(), view.height());
    const QRectF around = QRectF({0, 0}, view).adjusted(-beyond, -beyond, beyond, beyond);
    return from == to ? QPolygonF() : partOnTheRight(around, {from, to});
}

QPolygonF simplified(const QPolygonF& curve, double tolerance)
{
    std::vector<core::Vec3> path;
    for (const QPointF& p : curve)
        path.emplace_back(p.x(), p.y(), 0);
    QPolygonF result;
    for (const std::size_t i : core::simplifiedPath(path, tolerance))
        result << curve[static_cast<qsizetype>(i)];
    return result;
}
} // namespace ui
