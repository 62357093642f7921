#include "ui/print/print_legend.h"

#include <QLocale>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace ui
{
namespace
{
constexpr int stripHeight = 14, labelGap = 4;
constexpr std::uint8_t maxSound = 127;

/// Returns the colour of a shade, 0 to 1, in sRGB, as in clay.frag: blue to pale for good places, yellow to vermilion
/// for faults. Colour-blind people can distinguish them (Okabe and Ito 2008).
QColor colorOf(double shade)
{
    const auto mixed = [](const QColor& a, const QColor& b, double share) {
        const auto between = [share](int from, int to) {
            return static_cast<int>(std::lround(from + share * (to - from)));
        };
        return QColor(between(a.red(), b.red()), between(a.green(), b.green()), between(a.blue(), b.blue()));
    };
    return shade < 0.5 ? mixed({0, 114, 178}, {214, 232, 238}, 2 * shade)
                       : mixed({240, 228, 66}, {200, 60, 0}, 2 * shade - 1);
}
} // namespace

std::uint8_t PrintScale::shade(float value) const
{
    const bool isThickness = picture == core::PrintPicture::Thickness;
    const auto v = static_cast<double>(value);
    const bool isFault = isThickness ? v < limit : v > limit;
    if (isFault) {
        const double share = isThickness ? 1 - v / limit : (v - limit) / std::max(90 - limit, 1e-9);
        return static_cast<std::uint8_t>(maxSound + 1 + std::lround(std::clamp(share, 0.0, 1.0) * maxSound));
    }
    const double share = isThickness ? limit / v : v / std::max(limit, 1e-9);
    return static_cast<std::uint8_t>(std::lround(std::clamp(share, 0.0, 1.0) * maxSound));
}

std::shared_ptr<const core::Footprint> shadesOf(std::vector<core::Slot> slots, const std::vector<float>& values,
                                                const PrintScale& scale)
{
    auto shades = std::make_shared<core::Footprint>();
    shades->slots = std::move(slots);
    shades->weights.reserve(values.size());
    for (const float value : values)
        shades->weights.push_back(scale.shade(value));
    return shades;
}

PrintLegend::PrintLegend(QWidget* parent) : QWidget(parent)
{
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void PrintLegend::setScale(const PrintScale& scale)
{
    m_scale = scale;
    QStringList words;
    for (const Mark& mark : marks())
        words << mark.text;
    setAccessibleName(tr("Colours on the model"));
    setAccessibleDescription(words.join(QStringLiteral(", ")));
    setToolTip(tr("The meaning of the colours on the model. Hatched places are beyond the limit."));
    update();
}

/// Returns the labels of the scale, with the worst values at the left.
std::vector<PrintLegend::Mark> PrintLegend::marks() const
{
    const QLocale locale;
    const auto mm = [&](double value) { return tr("%1 mm").arg(locale.toString(value, 'g', 3)); };
    const auto degrees = [&](double value) { return tr("%1°").arg(locale.toString(value, 'g', 3)); };
    if (m_scale.picture == core::PrintPicture::Thickness)
        return {{0, mm(0)}, {0.5, mm(m_scale.limit)}, {0.75, mm(2 * m_scale.limit)}, {1, tr("thick")}};
    return {{0, degrees(90)}, {0.5, degrees(m_scale.limit)}, {1, degrees(0)}};
}

QSize PrintLegend::sizeHint() const
{
    return {200, stripHeight + labelGap + fontMetrics().height()};
}

void PrintLegend::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    const QRect strip(0, 0, width(), stripHeight);
    for (int x = 0; x < strip.width(); ++x)
        painter.fillRect(x, 0, 1, stripHeight, colorOf(1 - (x + 0.5) / strip.width()));
    painter.fillRect(QRect(0, 0, width() / 2, stripHeight), QBrush(QColor(0, 0, 0, 110), Qt::BDiagPattern));
    painter.setPen(palette().color(QPalette::Mid));
    painter.drawRect(strip.adjusted(0, 0, -1, -1));
    painter.setPen(palette().color(QPalette::WindowText));
    int free = -1;
    for (const Mark& mark : marks()) {
        const int wide = fontMetrics().horizontalAdvance(mark.text);
        const int x = std::clamp(static_cast<int>(mark.place * width()) - wide / 2, 0, width() - wide);
        if (x <= free)
            continue;
        painter.drawText(x, stripHeight + labelGap + fontMetrics().ascent(), mark.text);
        free = x + wide + labelGap;
    }
}
} // namespace ui
