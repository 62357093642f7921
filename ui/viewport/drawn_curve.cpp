#include "ui/viewport/drawn_curve.h"

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

double distanceToLine(const QPointF& p, const QPointF& from, const QPointF& to)
{
    const QPointF way = to - from;
    const double squared = QPointF::dotProduct(way, way);
    const double share = squared > 0 ? std::clamp(QPointF::dotProduct(p - from, way) / squared, 0.0, 1.0) : 0;
    const QPointF off = p - from - share * way;
    return std::hypot(off.x(), off.y());
}

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
    if (curve.size() < 3)
        return curve;
    std::vector<bool> isKept(static_cast<std::size_t>(curve.size()), false);
    isKept.front() = isKept.back() = true;
    std::vector<std::pair<qsizetype, qsizetype>> open{{0, curve.size() - 1}};
    while (!open.empty()) {
        const auto [first, last] = open.back();
        open.pop_back();
        qsizetype farthest = first;
        double most = tolerance;
        for (qsizetype i = first + 1; i < last; ++i) {
            const double away = distanceToLine(curve[i], curve[first], curve[last]);
            if (away > most) {
                most = away;
                farthest = i;
            }
        }
        if (farthest == first)
            continue;
        isKept[static_cast<std::size_t>(farthest)] = true;
        open.emplace_back(first, farthest);
        open.emplace_back(farthest, last);
    }
    QPolygonF result;
    for (qsizetype i = 0; i < curve.size(); ++i)
        if (isKept[static_cast<std::size_t>(i)])
            result << curve[i];
    return result;
}
} // namespace ui
