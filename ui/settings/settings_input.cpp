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
const QString stabilizerLengthKey = QStringLiteral("hand/string");
const QString turnSpeedKey = QStringLiteral("turntable/speed");
const QString clockwiseKey = QStringLiteral("turntable/clockwise");
const QString radiusShareKey = QStringLiteral("brush/radiusShare");
const QString themeKey = QStringLiteral("preferences/theme");
const QString keepsBackupsKey = QStringLiteral("preferences/keepsVersions");
const QString languageKey = QStringLiteral("preferences/language");
const QString textSizeKey = QStringLiteral("preferences/textSize");
const QString reducesMotionKey = QStringLiteral("preferences/calm");
const QString keyPresetKey = QStringLiteral("keys/preset");
const QString customKeys = QStringLiteral("keys/own/"); ///< and the action's id
const QString penKey = QStringLiteral("preferences/penExponent");

QString keyOf(core::Parameter parameter)
{
    const std::string_view key = core::info(parameter).key;
    return QStringLiteral("brush/") + QLatin1StringView(key.data(), static_cast<qsizetype>(key.size()));
}

double defaultOf(core::Parameter parameter)
{
    return parameter == core::Parameter::Spacing ? defaultSpacing : core::info(parameter).defaultValue;
}

struct InputSwitch
{
    QString key;
    bool InputPreferences::*what;
};
const InputSwitch inputSwitches[] = {
    {QStringLiteral("preferences/pressureToStrength"), &InputPreferences::pressureToStrength},
    {QStringLiteral("preferences/pressureToRadius"), &InputPreferences::pressureToRadius},
    {QStringLiteral("preferences/altMovesView"), &InputPreferences::altMovesView}};
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
    preferences.reducesMotion = stored::yesNo(m_settings, reducesMotionKey, preferences.reducesMotion);
    for (const InputSwitch& row : inputSwitches)
        preferences.input.*row.what = stored::yesNo(m_settings, row.key, preferences.input.*row.what);
    preferences.input.penExponent =
        stored::number(m_settings, penKey, minPenExponent, maxPenExponent, preferences.input.penExponent);
    preferences.keepsBackups = stored::yesNo(m_settings, keepsBackupsKey, preferences.keepsBackups);
    preferences.keys.preset = stored::choice(m_settings, keyPresetKey, shortcutPresets, preferences.keys.preset);
    for (const QString& key : m_settings.allKeys())
        if (key.startsWith(customKeys))
            preferences.keys.custom.insert(key.mid(customKeys.size()), m_settings.value(key).toString());
    return preferences;
}

void Settings::setPreferences(const Preferences& preferences)
{
    m_settings.setValue(themeKey, stored::wordFor(preferences.theme, themeChoices));
    m_settings.setValue(languageKey, stored::wordFor(preferences.language, languages));
    m_settings.setValue(textSizeKey, stored::wordFor(preferences.textSize, textSizes));
    m_settings.setValue(reducesMotionKey, preferences.reducesMotion);
    for (const InputSwitch& row : inputSwitches)
        m_settings.setValue(row.key, preferences.input.*row.what);
    m_settings.setValue(penKey, preferences.input.penExponent);
    m_settings.setValue(keepsBackupsKey, preferences.keepsBackups);
    m_settings.setValue(keyPresetKey, stored::wordFor(preferences.keys.preset, shortcutPresets));
    m_settings.remove(customKeys.chopped(1));
    for (auto own = preferences.keys.custom.cbegin(); own != preferences.keys.custom.cend(); ++own)
        m_settings.setValue(customKeys + own.key(), own.value());
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

double Settings::stabilizerLength() const
{
    return stored::number(m_settings, stabilizerLengthKey, minStabilizerLength, maxStabilizerLength,
                          defaultStabilizerLength);
}

void Settings::setStabilizerLength(double pixels)
{
    m_settings.setValue(stabilizerLengthKey, pixels);
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
