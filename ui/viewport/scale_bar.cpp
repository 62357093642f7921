#include "ui/viewport/scale_bar.h"

#include "ui/scene/orbit_camera.h"

#include <QEvent>
#include <QLocale>
#include <QPainter>
#include <QPainterPath>

#include <cmath>
#include <utility>

namespace ui
{
namespace
{
constexpr double longest = 140;                   ///< longest bar, pixels
constexpr int margin = 16, between = 4, tick = 8; ///< pixels
constexpr double minText = 0.001, maxText = 1e6;  ///< shortest and longest bar that is shown, mm

/// Returns the largest number up to `length` that is 1, 2 or 5 times a power of ten.
double roundedDown(double length)
{
    const double power = std::pow(10.0, std::floor(std::log10(length)));
    const double mantissa = length / power;
    return power * (mantissa >= 5 ? 5 : mantissa >= 2 ? 2 : 1);
}
} // namespace

ScaleBar::ScaleBar(QWidget* parent) : QWidget(parent)
{
    setObjectName(QStringLiteral("scaleBar"));
    setAttribute(Qt::WA_TransparentForMouseEvents);
    place();
    parent->installEventFilter(this);
}

void ScaleBar::showFor(const OrbitCamera& camera)
{
    const double perMm = camera.pixelsPerMm(camera.pivot());
    const double max = longest / perMm;
    const bool readable = std::isfinite(max) && max > minText && max < maxText;
    const double millimetres = readable ? roundedDown(max) : 0, pixels = millimetres * perMm;
    if (millimetres == m_millimetres && pixels == m_pixels)
        return;
    m_millimetres = millimetres;
    m_pixels = pixels;
    setAccessibleName(tr("Scale: %L1 mm").arg(millimetres));
    update();
}

void ScaleBar::setLight(bool light)
{
    if (std::exchange(m_light, light) != light)
        update();
}

void ScaleBar::paintEvent(QPaintEvent*)
{
    if (m_pixels <= 0)
        return;
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const double left = 2, right = left + m_pixels, base = height() - 3;
    QPainterPath bar, text;
    bar.addPolygon({{left, base - tick}, {left, base}, {right, base}, {right, base - tick}});
    text.addText({left + 2 * between, base - between - fontMetrics().descent()}, font(),
                 tr("%L1 mm").arg(m_millimetres));
    const QColor light(240, 242, 245), dark(28, 31, 36);
    QColor halo = m_light ? dark : light;
    halo.setAlpha(150);
    painter.strokePath(bar, QPen(halo, 4));
    painter.strokePath(text, QPen(halo, 3));
    painter.strokePath(bar, QPen(m_light ? light : dark, 1.5));
    painter.fillPath(text, m_light ? light : dark);
}

bool ScaleBar::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::Resize)
        place();
    return QWidget::eventFilter(watched, event);
}

void ScaleBar::place()
{
    const int height = fontMetrics().height() + tick + between;
    setGeometry(margin, parentWidget()->height() - height - margin, static_cast<int>(longest) + 2 * between, height);
}
} // namespace ui
