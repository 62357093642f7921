#include "ui/widgets/curve_widget.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>

namespace ui
{
namespace
{
constexpr int margin = 8;
constexpr int parts = 64;     ///< number of segments in the drawn curve
constexpr double fill = 0.25; ///< opacity of the area below the curve, 0 to 1
} // namespace

CurveWidget::CurveWidget(QWidget* parent) : QWidget(parent)
{
    setFocusPolicy(Qt::StrongFocus);
    setCursor(Qt::SizeVerCursor);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

QRectF CurveWidget::plot() const
{
    return QRectF(rect()).adjusted(margin, margin, -margin, -margin);
}

void CurveWidget::bendTo(const QPointF& at)
{
    const QRectF area = plot();
    bendTo(std::clamp((at.x() - area.left()) / area.width(), 0.0, 1.0),
           std::clamp((area.bottom() - at.y()) / area.height(), 0.0, 1.0));
}

void CurveWidget::paintEvent(QPaintEvent*)
{
    const QRectF area = plot();
    QPolygonF line;
    for (int i = 0; i <= parts; ++i) {
        const double x = static_cast<double>(i) / parts;
        line << QPointF(area.left() + x * area.width(), area.bottom() - valueAt(x) * area.height());
    }
    QPainterPath below;
    below.addPolygon(line);
    below.lineTo(area.bottomRight());
    below.lineTo(area.bottomLeft());

    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(rect(), palette().base());
    QColor shade = palette().highlight().color();
    shade.setAlphaF(fill);
    painter.fillPath(below, shade);
    painter.setPen(QPen(palette().highlight(), 2));
    painter.drawPolyline(line);
    painter.setPen(hasFocus() ? palette().highlight().color() : palette().mid().color());
    painter.drawRect(rect().adjusted(0, 0, -1, -1));
}

void CurveWidget::mousePressEvent(QMouseEvent* event)
{
    bendTo(event->position());
}

void CurveWidget::mouseMoveEvent(QMouseEvent* event)
{
    bendTo(event->position());
}

void CurveWidget::keyPressEvent(QKeyEvent* event)
{
    switch (event->key()) {
    case Qt::Key_Up:
    case Qt::Key_Right:
        return step(1);
    case Qt::Key_Down:
    case Qt::Key_Left:
        return step(-1);
    default:
        QWidget::keyPressEvent(event);
    }
}
} // namespace ui
