#include "app/headset/headset_settings_store.h"

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
/// Last parts of the keys of the haptic levels, indexed by vr::Sensation.
constexpr std::array<const char*, vr::sensationCount> sensations{"contact", "texture",  "fusion",
                                                                 "refusal", "menuStep", "hold"};

const QString presetKey = QStringLiteral("headset/preset");
const QString sculptingKey = QStringLiteral("headset/sculpting");
const QString raisedKey = QStringLiteral("headset/raised");
const QString turnsKey = QStringLiteral("headset/turnsBy");
const QString floorKey = QStringLiteral("headset/floor");
const QString passthroughKey = QStringLiteral("headset/passthrough");
const QString performanceKey = QStringLiteral("headset/performance");

QString feelKey(std::size_t sensation)
{
    return QStringLiteral("headset/feel/") + QLatin1StringView(sensations[sensation]);
}
} // namespace

vr::HeadsetSettings HeadsetSettingsStore::load() const
{
    vr::HeadsetSettings settings;
    settings.wands.preset = stored::choice(m_settings, presetKey, presets, settings.wands.preset);
    settings.wands.sculpting = stored::choice(m_settings, sculptingKey, sides, settings.wands.sculpting);
    using Panel = vr::SettingsPanel;
    settings.heightOffset =
        number(m_settings, raisedKey, -Panel::maxHeightOffset, Panel::maxHeightOffset, settings.heightOffset);
    settings.turnRate = number(m_settings, turnsKey, Panel::minTurnRate, Panel::maxTurnRate, settings.turnRate);
    settings.showsFloor = yesNo(m_settings, floorKey, settings.showsFloor);
    settings.hasPassthrough = yesNo(m_settings, passthroughKey, settings.hasPassthrough);
    settings.showsPerformance = yesNo(m_settings, performanceKey, settings.showsPerformance);
    for (std::size_t i = 0; i < vr::sensationCount; ++i)
        settings.hapticLevels.of[i] = number(m_settings, feelKey(i), 0, 1, settings.hapticLevels.of[i]);
    return settings;
}

void HeadsetSettingsStore::save(const vr::HeadsetSettings& settings)
{
    m_settings.setValue(presetKey, wordFor(settings.wands.preset, presets));
    m_settings.setValue(sculptingKey, wordFor(settings.wands.sculpting, sides));
    m_settings.setValue(raisedKey, settings.heightOffset);
    m_settings.setValue(turnsKey, settings.turnRate);
    m_settings.setValue(floorKey, settings.showsFloor);
    m_settings.setValue(passthroughKey, settings.hasPassthrough);
    m_settings.setValue(performanceKey, settings.showsPerformance);
    for (std::size_t i = 0; i < vr::sensationCount; ++i)
        m_settings.setValue(feelKey(i), settings.hapticLevels.of[i]);
}
} // namespace app
