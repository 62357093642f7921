#include "ui/brush/color_wheel.h"

#include "ui/util/color_convert.h"

#include <QConicalGradient>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ui
{
namespace
{
constexpr double ringWidth = 16, ringGap = 4, handleRadius = 6;
constexpr double keyStep = 0.02, hueStep = 1.0 / 72;

QColor hsv(double hue, double saturation, double value)
{
    return QColor::fromHsvF(static_cast<float>(hue), static_cast<float>(saturation), static_cast<float>(value));
}
} // namespace

ColorWheel::ColorWheel(QWidget* parent) : QWidget(parent)
{
    setObjectName(QStringLiteral("colorWheel"));
    setAccessibleName(tr("Hue, saturation and value"));
    setToolTip(tr(
        "The ring is the hue, the square its saturation and value. Drag, or use the arrow keys and Page Up and Down."));
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
}

core::Rgb ColorWheel::color() const
{
    return toRgb(hsv(m_hue, m_saturation, m_value));
}

void ColorWheel::setColor(const core::Rgb& color)
{
    if (color == this->color())
        return;
    const QColor given = toQt(color);
    if (given.hsvHueF() >= 0)
        m_hue = static_cast<double>(given.hsvHueF());
    if (given.value() > 0)
        m_saturation = static_cast<double>(given.hsvSaturationF());
    m_value = static_cast<double>(given.valueF());
    update();
}

double ColorWheel::outerRadius() const
{
    return std::min(width(), height()) / 2.0 - 1;
}

QPointF ColorWheel::middle() const
{
    return QRectF(rect()).center();
}

QRectF ColorWheel::square() const
{
    const double half = (outerRadius() - ringWidth - ringGap) / std::numbers::sqrt2;
    return {middle() - QPointF(half, half), QSizeF(2 * half, 2 * half)};
}

/// Returns the position of a hue on the ring. Red is at the right, and hue increases anticlockwise.
QPointF ColorWheel::placeOfHue(double hue) const
{
    const double angle = 2 * std::numbers::pi * hue, radius = outerRadius() - ringWidth / 2;
    return middle() + radius * QPointF(std::cos(angle), -std::sin(angle));
}

QPointF ColorWheel::placeInSquare(double saturation, double value) const
{
    const QRectF area = square();
    return {area.left() + saturation * area.width(), area.bottom() - value * area.height()};
}

void ColorWheel::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    drawRing(painter);
    drawSquare(painter);
    drawHandle(painter, placeOfHue(m_hue), hsv(m_hue, 1, 1));
    drawHandle(painter, placeInSquare(m_saturation, m_value), toQt(color()));
    if (hasFocus()) {
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(palette().highlight(), 2));
        painter.drawEllipse(middle(), outerRadius(), outerRadius());
    }
}

void ColorWheel::drawRing(QPainter& painter) const
{
    QConicalGradient hues(middle(), 0);
    for (int i = 0; i <= 6; ++i)
        hues.setColorAt(i / 6.0, hsv(i % 6 / 6.0, 1, 1));
    QPainterPath ring;
    ring.addEllipse(middle(), outerRadius(), outerRadius());
    ring.addEllipse(middle(), outerRadius() - ringWidth, outerRadius() - ringWidth);
    painter.fillPath(ring, hues);
}

void ColorWheel::drawSquare(QPainter& painter) const
{
    const QRectF area = square();
    QLinearGradient saturation(area.topLeft(), area.topRight());
    saturation.setColorAt(0, Qt::white);
    saturation.setColorAt(1, hsv(m_hue, 1, 1));
    painter.fillRect(area, saturation);
    QLinearGradient value(area.topLeft(), area.bottomLeft());
    value.setColorAt(0, QColor(0, 0, 0, 0));
    value.setColorAt(1, Qt::black);
    painter.fillRect(area, value);
}

/// Draws a white circle on a wider black circle, which is visible on every colour.
void ColorWheel::drawHandle(QPainter& painter, const QPointF& at, const QColor& inside) const
{
    painter.setBrush(inside);
    painter.setPen(QPen(Qt::black, 3));
    painter.drawEllipse(at, handleRadius, handleRadius);
    painter.setPen(QPen(Qt::white, 1.5));
    painter.drawEllipse(at, handleRadius, handleRadius);
}

void ColorWheel::mousePressEvent(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton)
        return;
    const QPointF from = event->position() - middle();
    m_dragged = std::hypot(from.x(), from.y()) > outerRadius() - ringWidth - ringGap / 2 ? Part::Ring : Part::Square;
    drag(event->position());
}

void ColorWheel::mouseMoveEvent(QMouseEvent* event)
{
    if (event->buttons() & Qt::LeftButton)
        drag(event->position());
}

void ColorWheel::drag(const QPointF& to)
{
    const QPointF from = to - middle();
    const QRectF area = square();
    if (m_dragged == Part::Ring)
        set(std::atan2(-from.y(), from.x()) / (2 * std::numbers::pi), m_saturation, m_value);
    else
        set(m_hue, (to.x() - area.left()) / area.width(), (area.bottom() - to.y()) / area.height());
}

void ColorWheel::keyPressEvent(QKeyEvent* event)
{
    switch (event->key()) {
    case Qt::Key_Left:
        return set(m_hue, m_saturation - keyStep, m_value);
    case Qt::Key_Right:
        return set(m_hue, m_saturation + keyStep, m_value);
    case Qt::Key_Up:
        return set(m_hue, m_saturation, m_value + keyStep);
    case Qt::Key_Down:
        return set(m_hue, m_saturation, m_value - keyStep);
    case Qt::Key_PageUp:
        return set(m_hue + hueStep, m_saturation, m_value);
    case Qt::Key_PageDown:
        return set(m_hue - hueStep, m_saturation, m_value);
    default:
        QWidget::keyPressEvent(event);
    }
}

void ColorWheel::set(double hue, double saturation, double value)
{
    m_hue = hue - std::floor(hue);
    m_saturation = std::clamp(saturation, 0.0, 1.0);
    m_value = std::clamp(value, 0.0, 1.0);
    update();
    Q_EMIT colorChanged(color());
}
} // namespace ui
