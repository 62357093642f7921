#include "falloff_curve.h"

#include "messages.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>

namespace ui
{
namespace
{
constexpr int margin = 8;
constexpr int parts = 64; ///< of the drawn line
constexpr double fill = 0.25; ///< how much of the line's colour lies below it

const int mostFalloff = static_cast<int>(core::info(core::Parameter::Falloff).max);
} // namespace

FalloffCurve::FalloffCurve(BrushSettings* brush, QWidget* parent) : QWidget(parent), m_brush(brush)
{
    setObjectName(QStringLiteral("falloffCurve"));
    setAccessibleName(Messages::name(core::Parameter::Falloff));
    setToolTip(tr("How the brush fades from its centre to its rim. Drag to bend it."));
    setFocusPolicy(Qt::StrongFocus);
    setCursor(Qt::SizeVerCursor);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    connect(brush, &BrushSettings::changed, this, qOverload<>(&QWidget::update));
}

QRectF FalloffCurve::plot() const
{
    return QRectF(rect()).adjusted(margin, margin, -margin, -margin);
}

int FalloffCurve::falloffAt(const QPointF& at) const
{
    const QRectF area = plot();
    const double x = std::clamp((at.x() - area.left()) / area.width(), 0.0, 1.0);
    const double y = std::clamp((area.bottom() - at.y()) / area.height(), 0.0, 1.0);
    int nearest = 0;
    for (int n = core::leastFalloff; n <= mostFalloff; ++n) {
        if (std::abs(core::falloff(x, n) - y) < std::abs(core::falloff(x, nearest) - y))
            nearest = n;
    }
    return nearest;
}

void FalloffCurve::paintEvent(QPaintEvent*)
{
    const QRectF area = plot();
    QPolygonF line;
    for (int i = 0; i <= parts; ++i) {
        const double x = static_cast<double>(i) / parts;
        line << QPointF(area.left() + x * area.width(), area.bottom() - core::falloff(x, falloff()) * area.height());
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

void FalloffCurve::mousePressEvent(QMouseEvent* event)
{
    m_brush->setValue(core::Parameter::Falloff, falloffAt(event->position()));
}

void FalloffCurve::mouseMoveEvent(QMouseEvent* event)
{
    m_brush->setValue(core::Parameter::Falloff, falloffAt(event->position()));
}

void FalloffCurve::keyPressEvent(QKeyEvent* event)
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

/// Past what lies between no weighting and the least n.
void FalloffCurve::step(int by)
{
    int n = falloff() + by;
    while (n > 0 && n < mostFalloff && !core::isFalloff(n))
        n += by;
    m_brush->setValue(core::Parameter::Falloff, std::clamp(n, 0, mostFalloff));
}
} // namespace ui
