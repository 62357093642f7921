#include "app/headset/headset_settings.h"

#include "ui/settings/stored_values.h"
#include "vr/panels/panel_content.h"

namespace app
{
namespace
{
namespace stored = ui::stored;
using stored::number, stored::wordFor, stored::yesNo;

constexpr std::array<ui::Named<vr::ButtonPreset>, 3> presets{{{vr::ButtonPreset::Paper, "paper"},
                                                              {vr::ButtonPreset::Studio, "studio"},
                                                              {vr::ButtonPreset::OneHand, "one-hand"}}};
constexpr std::array<ui::Named<vr::Side>, 2> sides{{{vr::Side::Left, "left"}, {vr::Side::Right, "right"}}};
constexpr std::array<const char*, vr::sensationCount> sensations{"contact", "texture",  "fusion",
                                                                 "refusal", "menuStep", "hold"}; ///< by Sensation

const QString presetKey = QStringLiteral("headset/preset");
const QString sculptingKey = QStringLiteral("headset/sculpting");
const QString raisedKey = QStringLiteral("headset/raised");
const QString turnsKey = QStringLiteral("headset/turnsBy");
const QString floorKey = QStringLiteral("headset/floor");
const QString performanceKey = QStringLiteral("headset/performance");

QString feelKey(std::size_t sensation)
{
    return QStringLiteral("headset/feel/") + QLatin1StringView(sensations[sensation]);
}
} // namespace

vr::HeadsetSettings HeadsetSettings::choice() const
{
    vr::HeadsetSettings choice;
    choice.wands.preset = stored::choice(m_settings, presetKey, presets, choice.wands.preset);
    choice.wands.sculpting = stored::choice(m_settings, sculptingKey, sides, choice.wands.sculpting);
    using Panel = vr::SettingsPanel;
    choice.heightOffset =
        number(m_settings, raisedKey, -Panel::maxHeightOffset, Panel::maxHeightOffset, choice.heightOffset);
    choice.turnRate = number(m_settings, turnsKey, Panel::minTurnRate, Panel::maxTurnRate, choice.turnRate);
    choice.showsFloor = yesNo(m_settings, floorKey, choice.showsFloor);
    choice.showsPerformance = yesNo(m_settings, performanceKey, choice.showsPerformance);
    for (std::size_t i = 0; i < vr::sensationCount; ++i)
        choice.hapticLevels.of[i] = number(m_settings, feelKey(i), 0, 1, choice.hapticLevels.of[i]);
    return choice;
}

void HeadsetSettings::setChoice(const vr::HeadsetSettings& choice)
{
    m_settings.setValue(presetKey, wordFor(choice.wands.preset, presets));
    m_settings.setValue(sculptingKey, wordFor(choice.wands.sculpting, sides));
    m_settings.setValue(raisedKey, choice.heightOffset);
    m_settings.setValue(turnsKey, choice.turnRate);
    m_settings.setValue(floorKey, choice.showsFloor);
    m_settings.setValue(performanceKey, choice.showsPerformance);
    for (std::size_t i = 0; i < vr::sensationCount; ++i)
        m_settings.setValue(feelKey(i), choice.hapticLevels.of[i]);
}
} // namespace app
