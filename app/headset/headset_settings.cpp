#include "app/headset/headset_settings.h"

#include "ui/settings/stored_values.h"
#include "vr/panels/panel_content.h"

namespace app
{
namespace
{
namespace stored = ui::stored;
using stored::number, stored::wordFor, stored::yesNo;

constexpr std::array<ui::Named<vr::Preset>, 3> presets{
    {{vr::Preset::Paper, "paper"}, {vr::Preset::Studio, "studio"}, {vr::Preset::OneHand, "one-hand"}}};
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

vr::HeadsetChoice HeadsetSettings::choice() const
{
    vr::HeadsetChoice choice;
    choice.hands.preset = stored::choice(m_settings, presetKey, presets, choice.hands.preset);
    choice.hands.sculpting = stored::choice(m_settings, sculptingKey, sides, choice.hands.sculpting);
    using Panel = vr::SettingsPanel;
    choice.raised = number(m_settings, raisedKey, -Panel::mostRaised, Panel::mostRaised, choice.raised);
    choice.turnsBy = number(m_settings, turnsKey, Panel::slowestTurn, Panel::fastestTurn, choice.turnsBy);
    choice.showsFloor = yesNo(m_settings, floorKey, choice.showsFloor);
    choice.showsPerformance = yesNo(m_settings, performanceKey, choice.showsPerformance);
    for (std::size_t i = 0; i < vr::sensationCount; ++i)
        choice.feel.of[i] = number(m_settings, feelKey(i), 0, 1, choice.feel.of[i]);
    return choice;
}

void HeadsetSettings::setChoice(const vr::HeadsetChoice& choice)
{
    m_settings.setValue(presetKey, wordFor(choice.hands.preset, presets));
    m_settings.setValue(sculptingKey, wordFor(choice.hands.sculpting, sides));
    m_settings.setValue(raisedKey, choice.raised);
    m_settings.setValue(turnsKey, choice.turnsBy);
    m_settings.setValue(floorKey, choice.showsFloor);
    m_settings.setValue(performanceKey, choice.showsPerformance);
    for (std::size_t i = 0; i < vr::sensationCount; ++i)
        m_settings.setValue(feelKey(i), choice.feel.of[i]);
}
} // namespace app
