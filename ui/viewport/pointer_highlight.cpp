#include "ui/viewport/pointer_highlight.h"

#include <QPainter>

#include <cmath>

namespace ui
{
namespace
{
/// width and height of the widget, pixels; contains the ring at its largest
constexpr int lightSide = 72;
constexpr double spotRadius = 7, minRing = 12, maxRing = 32; ///< pixels
constexpr int frameMs = 40;
/// duration of the ring's animation, ms; fixed progress (0 to 1) shown without animation, as in the headset
constexpr double pulseMs = 1200, stillPulse = 0.4;
constexpr QColor lightColor(160, 255, 70); ///< a colour that nothing else has; as in the headset
} // namespace

PointerHighlight::PointerHighlight(QWidget* parent) : QWidget(parent)
{
    setObjectName(QStringLiteral("pointLight"));
    setAttribute(Qt::WA_TransparentForMouseEvents);
    resize(lightSide, lightSide);
    hide();
    m_timer.setInterval(frameMs);
    connect(&m_timer, &QTimer::timeout, this, [this] {
        m_pulse = m_reducesMotion ? stillPulse : std::fmod(m_pulse + frameMs / pulseMs, 1.0);
        update();
    });
}

void PointerHighlight::place(const std::optional<QPointF>& middle)
{
    setVisible(middle.has_value());
    if (!middle)
        return m_timer.stop();
    move((*middle - QPointF(lightSide, lightSide) / 2).toPoint());
    if (!m_timer.isActive())
        m_timer.start();
}

void PointerHighlight::setReducesMotion(bool reducesMotion)
{
    m_reducesMotion = reducesMotion;
}

/// Draws light shapes between dark edges, to be visible on every material.
void PointerHighlight::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.translate(lightSide / 2.0, lightSide / 2.0);
    const double ring = minRing + (maxRing - minRing) * m_pulse;
    const double strength = 1 - m_pulse;
    QColor dark(0, 0, 0), bright = lightColor;
    dark.setAlphaF(static_cast<float>(0.55 * strength));
    bright.setAlphaF(static_cast<float>(strength));
    painter.setPen(QPen(dark, 6));
    painter.drawEllipse(QPointF(), ring, ring);
    painter.setPen(QPen(bright, 3));
    painter.drawEllipse(QPointF(), ring, ring);
    painter.setPen(QPen(QColor(0, 0, 0, 170), 2.5));
    painter.setBrush(lightColor);
    painter.drawEllipse(QPointF(), spotRadius, spotRadius);
    painter.setPen(Qt::NoPen);
    painter.setBrush(Qt::white);
    painter.drawEllipse(QPointF(), spotRadius * 0.45, spotRadius * 0.45);
}
} // namespace ui
