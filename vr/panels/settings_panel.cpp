#include "vr/panels/panel_builder.h"
#include "vr/panels/panel_content.h"
#include "vr/panels/panel_theme.h"

#include <algorithm>
#include <cmath>

namespace vr
{
namespace
{
constexpr double settingsWidth = 940, settingsNameWidth = 300;
constexpr double settingsDistance = 0.6; ///< metres from which the panel is read: arm's length
constexpr double raiseStep = 0.02, turnStep = 5, levelStep = 0.05;

/// Returns the value clamped to its range; NaN becomes the least value.
double within(double value, double min, double max)
{
    return value >= min ? std::min(value, max) : min;
}

constexpr PanelSlider sliderOf(std::size_t sensation)
{
    return static_cast<PanelSlider>(static_cast<std::size_t>(PanelSlider::Contact) + sensation);
}
static_assert(sliderOf(static_cast<std::size_t>(Sensation::Contact)) == PanelSlider::Contact);
static_assert(sliderOf(static_cast<std::size_t>(Sensation::Hold)) == PanelSlider::Hold);
} // namespace

HeadsetSettings SettingsPanel::after(HeadsetSettings settings, const PanelAction& action)
{
    if (const auto* preset = std::get_if<ButtonPreset>(&action))
        settings.wands.preset = *preset;
    else if (const auto* hand = std::get_if<ChooseHand>(&action))
        settings.wands.sculpting = hand->sculpting;
    else if (const auto* ground = std::get_if<ShowFloor>(&action))
        settings.showsFloor = ground->isShown;
    else if (const auto* room = std::get_if<ShowPassthrough>(&action))
        settings.hasPassthrough = room->isShown;
    else if (const auto* numbers = std::get_if<ShowPerformance>(&action))
        settings.showsPerformance = numbers->isShown;
    else if (const auto* moved = std::get_if<Slide>(&action))
        slide(settings, *moved);
    return settings;
}

void SettingsPanel::slide(HeadsetSettings& settings, const Slide& slide)
{
    if (slide.slider == PanelSlider::Height)
        settings.heightOffset = within(slide.value, -maxHeightOffset, maxHeightOffset);
    else if (slide.slider == PanelSlider::TurnSpeed)
        settings.turnRate = within(slide.value, minTurnRate, maxTurnRate);
    for (std::size_t i = 0; i < sensationCount; ++i)
        if (slide.slider == sliderOf(i))
            settings.hapticLevels.of[i] = within(slide.value, 0, 1);
}

QString SettingsPanel::nameOf(Sensation sensation)
{
    switch (sensation) {
    case Sensation::Contact:
        return tr("First contact");
    case Sensation::Texture:
        return tr("Sculpting");
    case Sensation::Fusion:
        return tr("Surfaces join");
    case Sensation::Refusal:
        return tr("Refusal");
    case Sensation::MenuStep:
        return tr("Menus");
    case Sensation::Hold:
        return tr("Holding a button");
    }
    return {};
}

void SettingsPanel::addGeneral(PanelBuilder& builder) const
{
    const auto [preset, sculpting] = settings.wands;
    builder.addChoice(tr("Buttons"), settingsNameWidth,
                      {{tr("Paper"), {}, ButtonPreset::Paper, preset == ButtonPreset::Paper},
                       {tr("Studio"), {}, ButtonPreset::Studio, preset == ButtonPreset::Studio},
                       {tr("One hand"), {}, ButtonPreset::OneHand, preset == ButtonPreset::OneHand}});
    builder.addChoice(tr("Sculpting hand"), settingsNameWidth,
                      {{tr("Left"), {}, ChooseHand{Side::Left}, sculpting == Side::Left},
                       {tr("Right"), {}, ChooseHand{Side::Right}, sculpting == Side::Right}});
    addModel(builder);
    builder.addSwitch({tr("Floor grid"), onOff(settings.showsFloor), ShowFloor{!settings.showsFloor}},
                      settingsNameWidth);
    addPassthrough(builder);
    builder.addSwitch(
        {tr("Performance"), onOff(settings.showsPerformance), ShowPerformance{!settings.showsPerformance}},
        settingsNameWidth);
}

SwitchLook SettingsPanel::onOff(bool isOn)
{
    return {isOn ? tr("On") : tr("Off"), isOn};
}

/// Adds the switch for the real room. A headset that cannot show it has a switch that says so.
void SettingsPanel::addPassthrough(PanelBuilder& builder) const
{
    const SwitchLook look =
        offersPassthrough ? onOff(settings.hasPassthrough) : SwitchLook{tr("Not on this headset"), false};
    builder.addSwitch({tr("Real room"), look, ShowPassthrough{!settings.hasPassthrough}, offersPassthrough},
                      settingsNameWidth);
}

void SettingsPanel::addModel(PanelBuilder& builder) const
{
    const int centimetres = static_cast<int>(std::lround(settings.heightOffset * 100));
    //: %1: a number, perhaps with a sign
    const QString height =
        tr("%1 cm").arg(QString::number(centimetres).prepend(centimetres > 0 ? QStringLiteral("+") : QString()));
    builder.addSlider({tr("Raise model"),
                       height,
                       SliderLook{.min = -maxHeightOffset, .max = maxHeightOffset, .step = raiseStep},
                       {PanelSlider::Height, settings.heightOffset}},
                      settingsNameWidth);
    //: %1: degrees a second
    const QString speed = tr("%1°/s").arg(std::lround(settings.turnRate));
    builder.addSlider({tr("Turning speed"),
                       speed,
                       SliderLook{.min = minTurnRate, .max = maxTurnRate, .step = turnStep, .origin = minTurnRate},
                       {PanelSlider::TurnSpeed, settings.turnRate}},
                      settingsNameWidth);
}

void SettingsPanel::addHaptics(PanelBuilder& builder) const
{
    for (std::size_t i = 0; i < sensationCount; ++i) {
        const double level = settings.hapticLevels.of[i];
        const QString value = tr("%1 %").arg(std::lround(level * 100));
        builder.addSlider(
            {nameOf(static_cast<Sensation>(i)), value, SliderLook{.step = levelStep}, {sliderOf(i), level}},
            settingsNameWidth);
    }
}

PanelLayout SettingsPanel::layout() const
{
    PanelBuilder builder(PanelKind::Settings, settingsWidth, settingsDistance);
    builder.addTitle({tr("Settings")}, {{{.icon = QStringLiteral("panel-close"), .isFlat = true},
                                         ShowPanel{PanelKind::Settings, false}}});
    builder.addChoice({}, 0,
                      {{tr("General"), {}, SettingsPage::General, page == SettingsPage::General},
                       {tr("Vibration"), {}, SettingsPage::Haptics, page == SettingsPage::Haptics}});
    builder.skip(theme::gap);
    if (page == SettingsPage::General)
        addGeneral(builder);
    else
        addHaptics(builder);
    return builder.finished();
}
} // namespace vr
