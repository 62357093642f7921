// What the hand holds and how it is taken: brush, pen, keys, turntable.

#include "ui/settings/settings.h"

#include "ui/settings/stored_values.h"

namespace ui
{
namespace
{
constexpr double defaultRadiusShare = 0.1;

const QString alphaKey = QStringLiteral("brush/alpha");
const QString alphaFollowsKey = QStringLiteral("brush/alphaFollows");
const QString modelKey = QStringLiteral("brush/model");
const QString steadyKey = QStringLiteral("hand/steady");
const QString stringKey = QStringLiteral("hand/string");
const QString turnSpeedKey = QStringLiteral("turntable/speed");
const QString clockwiseKey = QStringLiteral("turntable/clockwise");
const QString radiusShareKey = QStringLiteral("brush/radiusShare");
const QString themeKey = QStringLiteral("preferences/theme");
const QString keepsVersionsKey = QStringLiteral("preferences/keepsVersions");
const QString languageKey = QStringLiteral("preferences/language");
const QString textSizeKey = QStringLiteral("preferences/textSize");
const QString calmKey = QStringLiteral("preferences/calm");
const QString keyPresetKey = QStringLiteral("keys/preset");
const QString ownKeys = QStringLiteral("keys/own/"); ///< and the action's id
const QString penKey = QStringLiteral("preferences/penExponent");

QString keyOf(core::Parameter parameter)
{
    const std::string_view key = core::info(parameter).key;
    return QStringLiteral("brush/") + QLatin1StringView(key.data(), static_cast<qsizetype>(key.size()));
}

double defaultOf(core::Parameter parameter)
{
    return parameter == core::Parameter::Spacing ? handSpacing : core::info(parameter).defaultValue;
}

struct HabitSwitch
{
    QString key;
    bool HandHabits::*what;
};
const HabitSwitch habitSwitches[] = {
    {QStringLiteral("preferences/pressureToStrength"), &HandHabits::pressureToStrength},
    {QStringLiteral("preferences/pressureToRadius"), &HandHabits::pressureToRadius},
    {QStringLiteral("preferences/altMovesView"), &HandHabits::altMovesView}};
} // namespace

double Settings::value(core::Parameter parameter) const
{
    const core::ParameterInfo& row = core::info(parameter);
    return stored::number(m_settings, keyOf(parameter), row.min, row.max, defaultOf(parameter));
}

void Settings::setValue(core::Parameter parameter, double value)
{
    m_settings.setValue(keyOf(parameter), value);
}

double Settings::radiusShare() const
{
    return stored::number(m_settings, radiusShareKey, minRadiusShare, maxRadiusShare, defaultRadiusShare);
}

void Settings::setRadiusShare(double share)
{
    m_settings.setValue(radiusShareKey, share);
}

Preferences Settings::preferences() const
{
    Preferences preferences;
    preferences.theme = stored::choice(m_settings, themeKey, themeChoices, preferences.theme);
    preferences.language = stored::choice(m_settings, languageKey, languages, preferences.language);
    preferences.textSize = stored::choice(m_settings, textSizeKey, textSizes, preferences.textSize);
    preferences.isCalm = stored::yesNo(m_settings, calmKey, preferences.isCalm);
    for (const HabitSwitch& row : habitSwitches)
        preferences.hand.*row.what = stored::yesNo(m_settings, row.key, preferences.hand.*row.what);
    preferences.hand.penExponent =
        stored::number(m_settings, penKey, minPenExponent, maxPenExponent, preferences.hand.penExponent);
    preferences.keepsVersions = stored::yesNo(m_settings, keepsVersionsKey, preferences.keepsVersions);
    preferences.keys.preset = stored::choice(m_settings, keyPresetKey, keyPresets, preferences.keys.preset);
    for (const QString& key : m_settings.allKeys())
        if (key.startsWith(ownKeys))
            preferences.keys.own.insert(key.mid(ownKeys.size()), m_settings.value(key).toString());
    return preferences;
}

void Settings::setPreferences(const Preferences& preferences)
{
    m_settings.setValue(themeKey, stored::wordFor(preferences.theme, themeChoices));
    m_settings.setValue(languageKey, stored::wordFor(preferences.language, languages));
    m_settings.setValue(textSizeKey, stored::wordFor(preferences.textSize, textSizes));
    m_settings.setValue(calmKey, preferences.isCalm);
    for (const HabitSwitch& row : habitSwitches)
        m_settings.setValue(row.key, preferences.hand.*row.what);
    m_settings.setValue(penKey, preferences.hand.penExponent);
    m_settings.setValue(keepsVersionsKey, preferences.keepsVersions);
    m_settings.setValue(keyPresetKey, stored::wordFor(preferences.keys.preset, keyPresets));
    m_settings.remove(ownKeys.chopped(1));
    for (auto own = preferences.keys.own.cbegin(); own != preferences.keys.own.cend(); ++own)
        m_settings.setValue(ownKeys + own.key(), own.value());
}

StoredShapes Settings::shapes() const
{
    return {m_settings.value(alphaKey).toString(), stored::yesNo(m_settings, alphaFollowsKey, false),
            m_settings.value(modelKey).toString(), m_settings.value(stored::alphaFilesKey).toStringList(),
            m_settings.value(stored::modelFilesKey).toStringList()};
}

void Settings::setShapes(const StoredShapes& shapes)
{
    m_settings.setValue(alphaKey, shapes.alpha);
    m_settings.setValue(alphaFollowsKey, shapes.alphaFollows);
    m_settings.setValue(modelKey, shapes.model);
    m_settings.setValue(stored::alphaFilesKey, shapes.alphas);
    m_settings.setValue(stored::modelFilesKey, shapes.models);
}

bool Settings::isSteady() const
{
    return m_settings.value(steadyKey).toBool();
}

void Settings::setSteady(bool steady)
{
    m_settings.setValue(steadyKey, steady);
}

double Settings::stringLength() const
{
    return stored::number(m_settings, stringKey, minString, maxString, defaultString);
}

void Settings::setStringLength(double pixels)
{
    m_settings.setValue(stringKey, pixels);
}

double Settings::turnSpeed() const
{
    return stored::number(m_settings, turnSpeedKey, minTurn, maxTurn, defaultTurn);
}

void Settings::setTurnSpeed(double speed)
{
    m_settings.setValue(turnSpeedKey, speed);
}

bool Settings::turnsClockwise() const
{
    return m_settings.value(clockwiseKey).toBool();
}

void Settings::setTurnsClockwise(bool clockwise)
{
    m_settings.setValue(clockwiseKey, clockwise);
}
} // namespace ui
