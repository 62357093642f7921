#include "vr/panels/panel_builder.h"
#include "vr/panels/panel_content.h"
#include "vr/panels/panel_theme.h"

namespace vr
{
namespace
{
constexpr double colorWidth = 760, colorNameWidth = 136, colorValueWidth = 96, swatchHeight = 84, ownSwatchWidth = 220;
constexpr double colorDistance = 0.5; ///< metres from which the panel is read, the same as for the tools
constexpr int swatchColumns = 6;
constexpr std::array channels{&core::Rgb::r, &core::Rgb::g, &core::Rgb::b};
constexpr std::array sliders{PanelSlider::Red, PanelSlider::Green, PanelSlider::Blue};

QColor with(core::Rgb color, std::size_t channel, std::uint8_t value)
{
    color.*channels[channel] = value;
    return {color.r, color.g, color.b};
}
} // namespace

QString ColorPanel::nameOf(int channelNumber)
{
    return channelNumber == 0 ? tr("Red") : channelNumber == 1 ? tr("Green") : tr("Blue");
}

PanelLayout ColorPanel::layout() const
{
    PanelBuilder builder(PanelKind::Color, colorWidth, colorDistance);
    const std::vector<QRectF> head = cells(builder.nextRow(theme::titleRow), {0, ownSwatchWidth});
    builder.add(head[0], TextLook{.text = tr("Colour"), .role = TextRole::Title});
    builder.add({head[1], SwatchLook{color}});
    for (std::size_t i = 0; i < channels.size(); ++i) {
        const bool isChosen = channel == static_cast<int>(i);
        const QRectF row = builder.nextRow(theme::row);
        const int value = color.*channels[i];
        const std::vector<QRectF> places = cells(row, {colorNameWidth, 0, colorValueWidth});
        builder.add(places[0],
                    {{.text = nameOf(static_cast<int>(i)), .isChosen = isChosen}, ChooseChannel{static_cast<int>(i)}});
        builder.add(
            {places[1],
             SliderLook{
                 .max = 255, .step = 1, .first = with(color, i, 0), .last = with(color, i, 255), .isChosen = isChosen},
             Slide{sliders[i], static_cast<double>(value)}});
        builder.add(places[2], TextLook{QString::number(value), TextRole::Number, Qt::AlignRight | Qt::AlignVCenter});
    }
    const auto count = std::min<qsizetype>(swatches.size(), maxSwatches);
    std::vector<QRectF> places;
    for (qsizetype i = 0; i < count; ++i) {
        const auto column = static_cast<std::size_t>(i % swatchColumns);
        if (column == 0)
            places = evenCells(builder.nextRow(swatchHeight), swatchColumns);
        builder.add({places[column], SwatchLook{swatches[i], swatches[i] == color}, ChooseColor{swatches[i]}});
    }
    return builder.finished();
}
} // namespace vr
