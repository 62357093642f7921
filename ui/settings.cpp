#include "settings.h"

#include "color_convert.h"

#include <QDir>

#include <algorithm>
#include <cmath>

namespace ui
{
namespace
{
constexpr double defaultRadiusShare = 0.1;
constexpr qsizetype mostRecentFiles = 10;

// The key is what this version understands; a later one that stores something else takes another key.
const QString geometryKey = QStringLiteral("window/geometry");
const QString stateKey = QStringLiteral("window/state");
const QString historyKey = QStringLiteral("history/megabytes");
const QString recentKey = QStringLiteral("files/recent");
const QString folderKey = QStringLiteral("files/lastFolder");
const QString shownFolderKey = QStringLiteral("files/folder");
const QString fileOrderKey = QStringLiteral("files/order");
const QString filesDescendingKey = QStringLiteral("files/descending");
const QString filePictureKey = QStringLiteral("files/picture");
const QString steadyKey = QStringLiteral("hand/steady");
const QString stringKey = QStringLiteral("hand/string");
const QString drawnSidesKey = QStringLiteral("drawing/sides");
const QString drawnShadedKey = QStringLiteral("drawing/shaded");
const QString drawnDimensionsKey = QStringLiteral("drawing/dimensions");
const QString printerKey = QStringLiteral("print/printer");
const QString printersKey = QStringLiteral("print/printers");
const QString printWallKey = QStringLiteral("print/wall");
const QString printOverhangKey = QStringLiteral("print/overhang");
const QString printPictureKey = QStringLiteral("print/picture");
const QString turnSpeedKey = QStringLiteral("turntable/speed");
const QString clockwiseKey = QStringLiteral("turntable/clockwise");
const QString radiusShareKey = QStringLiteral("brush/radiusShare");
const QString themeKey = QStringLiteral("preferences/theme");
const QString keepsVersionsKey = QStringLiteral("preferences/keepsVersions");
const QString languageKey = QStringLiteral("preferences/language");
const QString startPageKey = QStringLiteral("start/page");
const QString keyPresetKey = QStringLiteral("keys/preset");
const QString ownKeys = QStringLiteral("keys/own/"); ///< and the action's id
const QString penKey = QStringLiteral("preferences/penExponent");
const QString materialKey = QStringLiteral("view/material");
const QString backgroundKey = QStringLiteral("view/background");
const QString showsReferencesKey = QStringLiteral("view/references");
const QString referenceKeys = QStringLiteral("reference/"); ///< and the side
const QString swatchesKey = QStringLiteral("color/swatches");

/// Clay, earth, slip, white, grey, black, and what children paint with.
const QList<core::Rgb> firstSwatches = {{200, 110, 80}, {138, 90, 60},  {242, 227, 204}, {255, 255, 255},
                                        {128, 128, 128}, {32, 32, 32},  {216, 58, 52},   {240, 180, 41},
                                        {76, 154, 74},  {47, 111, 181}, {122, 79, 160}};

QString keyOf(core::Parameter parameter)
{
    const std::string_view key = core::info(parameter).key;
    return QStringLiteral("brush/") + QLatin1StringView(key.data(), static_cast<qsizetype>(key.size()));
}

double defaultOf(core::Parameter parameter)
{
    return parameter == core::Parameter::Spacing ? handSpacing : core::info(parameter).defaultValue;
}

/// The default where nothing, or nothing sensible, is stored.
double number(const QSettings& settings, const QString& key, double least, double most, double otherwise)
{
    bool ok = false;
    const double stored = settings.value(key).toDouble(&ok);
    return ok && std::isfinite(stored) && stored >= least && stored <= most ? stored : otherwise;
}

bool yesNo(const QSettings& settings, const QString& key, bool otherwise)
{
    const QString stored = settings.value(key).toString();
    return stored == QLatin1StringView("true") || (stored != QLatin1StringView("false") && otherwise);
}

template <class T, std::size_t count>
T choice(const QSettings& settings, const QString& key, const std::array<Named<T>, count>& choices, T otherwise)
{
    const QString stored = settings.value(key).toString();
    const auto found = std::ranges::find_if(choices, [&](const Named<T>& row) { return stored == QLatin1StringView(row.key); });
    return found != choices.end() ? found->value : otherwise;
}

template <class T, std::size_t count> QString wordFor(T value, const std::array<Named<T>, count>& choices)
{
    return QLatin1StringView(std::ranges::find(choices, value, &Named<T>::value)->key);
}

struct HabitSwitch
{
    QString key;
    bool HandHabits::*what;
};
const HabitSwitch habitSwitches[] = {{QStringLiteral("preferences/pressureToStrength"), &HandHabits::pressureToStrength},
                                     {QStringLiteral("preferences/pressureToRadius"), &HandHabits::pressureToRadius},
                                     {QStringLiteral("preferences/altMovesView"), &HandHabits::altMovesView}};

struct LookSwitch
{
    QString key;
    bool ViewLook::*what;
};
const LookSwitch lookSwitches[] = {{QStringLiteral("view/wireframe"), &ViewLook::wireframe},
                                   {QStringLiteral("view/flat"), &ViewLook::flat},
                                   {QStringLiteral("view/ground"), &ViewLook::ground},
                                   {QStringLiteral("view/scaleBar"), &ViewLook::scaleBar}};
} // namespace

QByteArray Settings::windowGeometry() const
{
    return m_settings.value(geometryKey).toByteArray();
}

void Settings::setWindowGeometry(const QByteArray& geometry)
{
    m_settings.setValue(geometryKey, geometry);
}

QByteArray Settings::windowState() const
{
    return m_settings.value(stateKey).toByteArray();
}

void Settings::setWindowState(const QByteArray& state)
{
    m_settings.setValue(stateKey, state);
}

QStringList Settings::recentFiles() const
{
    return m_settings.value(recentKey).toStringList().mid(0, mostRecentFiles);
}

void Settings::addRecentFile(const QString& path)
{
    QStringList paths = recentFiles();
    paths.removeAll(path);
    paths.prepend(path);
    setRecentFiles(paths.mid(0, mostRecentFiles));
}

void Settings::setRecentFiles(const QStringList& paths)
{
    m_settings.setValue(recentKey, paths);
}

QString Settings::lastFolder() const
{
    const QString folder = m_settings.value(folderKey).toString();
    return !folder.isEmpty() && QDir(folder).exists() ? folder : QDir::homePath();
}

void Settings::setLastFolder(const QString& folder)
{
    m_settings.setValue(folderKey, folder);
}

FilesChoice Settings::files() const
{
    const QString folder = m_settings.value(shownFolderKey).toString();
    const bool isThere = !folder.isEmpty() && QDir(folder).exists();
    return {isThere ? folder : lastFolder(), choice(m_settings, fileOrderKey, fileOrders, FileOrder::Name), yesNo(m_settings, filesDescendingKey, false),
            static_cast<int>(number(m_settings, filePictureKey, minPicture, maxPicture, defaultPicture))};
}

void Settings::setFiles(const FilesChoice& choice)
{
    m_settings.setValue(shownFolderKey, choice.folder);
    m_settings.setValue(fileOrderKey, wordFor(choice.order, fileOrders));
    m_settings.setValue(filesDescendingKey, choice.descending);
    m_settings.setValue(filePictureKey, choice.picture);
}

int Settings::historyMegabytes() const
{
    return static_cast<int>(number(m_settings, historyKey, minHistoryMegabytes, maxHistoryMegabytes, defaultHistoryMegabytes));
}

void Settings::setHistoryMegabytes(int megabytes)
{
    m_settings.setValue(historyKey, megabytes);
}

DrawingChoice Settings::drawing() const
{
    const double sides = number(m_settings, drawnSidesKey, 0, static_cast<int>(DrawnSides::Top), 0);
    return {static_cast<DrawnSides>(static_cast<int>(sides)), m_settings.value(drawnShadedKey, false).toBool(),
            m_settings.value(drawnDimensionsKey, true).toBool()};
}

void Settings::setDrawing(const DrawingChoice& choice)
{
    m_settings.setValue(drawnSidesKey, static_cast<int>(choice.sides));
    m_settings.setValue(drawnShadedKey, choice.shaded);
    m_settings.setValue(drawnDimensionsKey, choice.dimensions);
}

PrintChoice Settings::print() const
{
    const PrintChoice usual;
    return {m_settings.value(printerKey).toString(), number(m_settings, printWallKey, 0, core::PrintLimits::mostWall, usual.wall),
            number(m_settings, printOverhangKey, 0, 90, usual.overhang), static_cast<int>(number(m_settings, printPictureKey, 0, 2, usual.picture))};
}

void Settings::setPrint(const PrintChoice& choice)
{
    m_settings.setValue(printerKey, choice.printer);
    m_settings.setValue(printWallKey, choice.wall);
    m_settings.setValue(printOverhangKey, choice.overhang);
    m_settings.setValue(printPictureKey, choice.picture);
}

QList<Printer> Settings::printers() const
{
    const QList<Printer> stored = printersOf(m_settings.value(printersKey).toStringList());
    return stored.isEmpty() ? usualPrinters() : stored;
}

void Settings::setPrinters(const QList<Printer>& printers)
{
    m_settings.setValue(printersKey, toLines(printers));
}

double Settings::value(core::Parameter parameter) const
{
    const core::ParameterInfo& row = core::info(parameter);
    return number(m_settings, keyOf(parameter), row.min, row.max, defaultOf(parameter));
}

void Settings::setValue(core::Parameter parameter, double value)
{
    m_settings.setValue(keyOf(parameter), value);
}

double Settings::radiusShare() const
{
    return number(m_settings, radiusShareKey, minRadiusShare, maxRadiusShare, defaultRadiusShare);
}

void Settings::setRadiusShare(double share)
{
    m_settings.setValue(radiusShareKey, share);
}

Preferences Settings::preferences() const
{
    Preferences preferences;
    preferences.theme = choice(m_settings, themeKey, themeChoices, preferences.theme);
    preferences.language = choice(m_settings, languageKey, languages, preferences.language);
    for (const HabitSwitch& row : habitSwitches)
        preferences.hand.*row.what = yesNo(m_settings, row.key, preferences.hand.*row.what);
    preferences.hand.penExponent = number(m_settings, penKey, minPenExponent, maxPenExponent, preferences.hand.penExponent);
    preferences.keepsVersions = yesNo(m_settings, keepsVersionsKey, preferences.keepsVersions);
    preferences.keys.preset = choice(m_settings, keyPresetKey, keyPresets, preferences.keys.preset);
    for (const QString& key : m_settings.allKeys())
        if (key.startsWith(ownKeys))
            preferences.keys.own.insert(key.mid(ownKeys.size()), m_settings.value(key).toString());
    return preferences;
}

void Settings::setPreferences(const Preferences& preferences)
{
    m_settings.setValue(themeKey, wordFor(preferences.theme, themeChoices));
    m_settings.setValue(languageKey, wordFor(preferences.language, languages));
    for (const HabitSwitch& row : habitSwitches)
        m_settings.setValue(row.key, preferences.hand.*row.what);
    m_settings.setValue(penKey, preferences.hand.penExponent);
    m_settings.setValue(keepsVersionsKey, preferences.keepsVersions);
    m_settings.setValue(keyPresetKey, wordFor(preferences.keys.preset, keyPresets));
    m_settings.remove(ownKeys.chopped(1));
    for (auto own = preferences.keys.own.cbegin(); own != preferences.keys.own.cend(); ++own)
        m_settings.setValue(ownKeys + own.key(), own.value());
}

void Settings::reset()
{
    for (const QString& key : m_settings.allKeys())
        if (key != recentKey && key != folderKey && key != swatchesKey && key != printersKey && !key.startsWith(referenceKeys))
            m_settings.remove(key);
    for (const auto& takeUp : m_onReset)
        takeUp();
}

void Settings::onReset(std::function<void()> takeUp)
{
    m_onReset.push_back(std::move(takeUp));
}

ViewLook Settings::look() const
{
    ViewLook look;
    look.material = choice(m_settings, materialKey, materials, look.material);
    look.background = choice(m_settings, backgroundKey, backgrounds, look.background);
    for (const LookSwitch& row : lookSwitches)
        look.*row.what = yesNo(m_settings, row.key, look.*row.what);
    return look;
}

void Settings::setLook(const ViewLook& look)
{
    m_settings.setValue(materialKey, wordFor(look.material, materials));
    m_settings.setValue(backgroundKey, wordFor(look.background, backgrounds));
    for (const LookSwitch& row : lookSwitches)
        m_settings.setValue(row.key, look.*row.what);
}

bool Settings::showsStartPage() const
{
    return yesNo(m_settings, startPageKey, true);
}

void Settings::setShowsStartPage(bool shows)
{
    m_settings.setValue(startPageKey, shows);
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
    return number(m_settings, stringKey, minString, maxString, defaultString);
}

void Settings::setStringLength(double pixels)
{
    m_settings.setValue(stringKey, pixels);
}

QList<core::Rgb> Settings::swatches() const
{
    if (!m_settings.contains(swatchesKey))
        return firstSwatches;
    QList<core::Rgb> swatches;
    for (const QString& name : m_settings.value(swatchesKey).toStringList())
        if (const QColor color(name); color.isValid())
            swatches << toRgb(color);
    return swatches;
}

void Settings::setSwatches(const QList<core::Rgb>& swatches)
{
    QStringList names;
    for (const core::Rgb& color : swatches)
        names << toQt(color).name();
    m_settings.setValue(swatchesKey, names);
}

StoredReference Settings::reference(OrbitCamera::Side side) const
{
    const QString key = referenceKeys + wordFor(side, viewSides) + u'/';
    const ReferencePlacement usual;
    StoredReference stored;
    stored.path = m_settings.value(key + QStringLiteral("path")).toString();
    stored.placement = {number(m_settings, key + QStringLiteral("width"), minReferenceWidth, maxReferenceWidth, usual.width),
                        number(m_settings, key + QStringLiteral("x"), -maxReferenceOffset, maxReferenceOffset, usual.x),
                        number(m_settings, key + QStringLiteral("y"), -maxReferenceOffset, maxReferenceOffset, usual.y),
                        number(m_settings, key + QStringLiteral("opacity"), minReferenceOpacity, 1, usual.opacity),
                        yesNo(m_settings, key + QStringLiteral("inFront"), usual.inFront)};
    return stored;
}

void Settings::setReference(OrbitCamera::Side side, const StoredReference& reference)
{
    const QString key = referenceKeys + wordFor(side, viewSides);
    m_settings.remove(key);
    if (reference.path.isEmpty())
        return;
    m_settings.setValue(key + QStringLiteral("/path"), reference.path);
    m_settings.setValue(key + QStringLiteral("/width"), reference.placement.width);
    m_settings.setValue(key + QStringLiteral("/x"), reference.placement.x);
    m_settings.setValue(key + QStringLiteral("/y"), reference.placement.y);
    m_settings.setValue(key + QStringLiteral("/opacity"), reference.placement.opacity);
    m_settings.setValue(key + QStringLiteral("/inFront"), reference.placement.inFront);
}

bool Settings::showsReferences() const
{
    return yesNo(m_settings, showsReferencesKey, true);
}

void Settings::setShowsReferences(bool shows)
{
    m_settings.setValue(showsReferencesKey, shows);
}

double Settings::turnSpeed() const
{
    return number(m_settings, turnSpeedKey, minTurn, maxTurn, defaultTurn);
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
