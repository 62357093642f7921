#pragma once

#include "ui/settings/brush_settings.h"
#include "ui/settings/drawing_settings.h"
#include "ui/settings/export_settings.h"
#include "ui/settings/file_browser_settings.h"
#include "ui/settings/insert_settings.h"
#include "ui/settings/preferences.h"
#include "ui/settings/printer_presets.h"
#include "ui/settings/stored_values.h"
#include "ui/settings/turntable_settings.h"
#include "ui/settings/view_appearance.h"

#include "core/geometry/geometry.h"

#include <QByteArray>
#include <QList>
#include <QString>
#include <QStringList>

#include <limits>
#include <tuple>

namespace ui
{
/// Useful radii as fractions of the model's longest side. The smallest that the lattice allows is slightly larger.
inline constexpr double minRadiusShare = 0.002, maxRadiusShare = 0.5;

inline constexpr int minHistoryMegabytes = 16, maxHistoryMegabytes = 65536, defaultHistoryMegabytes = 512;

/// Returns the initial swatches: clay, earth, slip, white, grey, black, and colours that children paint with.
QList<core::Rgb> firstSwatches();

/// Settings that are read and written individually, with their defaults.
struct Setting
{
    QByteArray windowGeometry, windowState;
    QStringList panels; ///< states of the side column's panels: SideColumn::panelStates()
    bool showsToolNames = false;
    bool showsStartPage = true;                     ///< shows the start page when the program starts without a file
    QStringList recentFiles;                        ///< paths, latest first
    QString lastFolder;                             ///< folder of the last file opened or exported
    int historyMegabytes = defaultHistoryMegabytes; ///< memory limit of the undo steps, MB
    double radiusShare = 0.1; ///< the brush's radius as a fraction of the model's longest side, to fit the next model
    bool sharesRadius = true; ///< keeps the radius when the tool changes
    bool isSteady = false;
    QStringList withoutAirbrush;                       ///< names of tools with the airbrush turned off
    double stabilizerLength = defaultStabilizerLength; ///< logical pixels
    double turnSpeed = defaultTurn;                    ///< speed of the turntable, degrees per second
    bool turnsClockwise = false;                       ///< direction of the turntable, seen from above
    bool showsReferences = true;
    InsertUse insertUse = InsertUse::Part; ///< the last choice of the dialogs that insert a model or a primitive
    QList<core::Rgb> swatches = firstSwatches();
    QList<PrinterPreset> printers = defaultPrinters(); ///< must not be empty
};

/// Shapes of the brush: the current ones, and files used before, latest first.
struct StoredShapes
{
    QString alpha; ///< name in core::builtInAlphas(), or a path; empty: none
    bool alphaFollows = false;
    QString model;              ///< path of a brush model; empty: a ball
    QStringList alphas, models; ///< paths

    bool operator==(const StoredShapes&) const = default;
};

/// The stored values of one tool, except its alpha (see ToolValues).
struct StoredTool
{
    double strength = 1, falloff = 4;
    double spacing = defaultSpacing;
    double airbrush = core::defaultAirbrush; ///< dabs per second; 0: none
    /// fraction of the model's longest side; 0: the tool never had a radius of its own
    double radiusShare = 0;
    bool anchored = false;
};

/// The alpha of a tool.
struct StoredToolAlpha
{
    QString alpha; ///< name in core::builtInAlphas(), or a path; empty: none
    bool alphaFollows = false;

    bool operator==(const StoredToolAlpha&) const = default;
};

/// The choices of the print check.
struct PrintSettings
{
    QString printer;      ///< name of the printer
    double wall = 0.8;    ///< smallest wall thickness, mm; thinner walls are marked
    double overhang = 45; ///< largest overhang, degrees; larger ones are marked
    int picture = 1;      ///< 1 + core::PrintPicture, the picture drawn on the model; 0: none
};

namespace stored
{
/// The valid values of a number.
struct Range
{
    double min = std::numeric_limits<double>::lowest(), max = std::numeric_limits<double>::max();
};

struct Anything
{};

/// The valid values of T: a range, the stored names of an enumeration, or anything.
template <class T>
using Valid = std::conditional_t<std::is_enum_v<T>, std::span<const Named<T>>,
                                 std::conditional_t<std::is_arithmetic_v<T>, Range, Anything>>;

/// Effect of Settings::reset() on a setting.
enum class Reset { ToDefault, Keep };

/// The storage of one member of S. A reset keeps what the user created (Reset::Keep).
template <class S, class T> struct Row
{
    T S::*member;
    const char* key;
    Valid<T> valid;
    Reset reset;
};

/// A member of S that is a struct with rows of its own.
template <class S, class T> struct Part
{
    T S::*member;
};

template <class S, class T>
constexpr Row<S, T> row(T S::*member, const char* key, std::type_identity_t<Valid<T>> valid = {},
                        Reset reset = Reset::ToDefault)
{
    return {member, key, valid, reset};
}

template <class S, class T> constexpr Row<S, T> keptRow(T S::*member, const char* key)
{
    return {member, key, {}, Reset::Keep};
}

/// The table of all settings, by struct. The defaults are those of the struct's members.
template <class S> inline constexpr auto rows = std::tuple<>();

template <>
inline constexpr auto rows<Setting> = std::tuple{
    row(&Setting::windowGeometry, "window/geometry"),
    row(&Setting::windowState, "window/state"),
    row(&Setting::panels, "window/panels"),
    row(&Setting::showsToolNames, "window/toolNames"),
    row(&Setting::showsStartPage, "start/page"),
    keptRow(&Setting::recentFiles, "files/recent"),
    keptRow(&Setting::lastFolder, "files/lastFolder"),
    row(&Setting::historyMegabytes, "history/megabytes", {minHistoryMegabytes, maxHistoryMegabytes}),
    row(&Setting::radiusShare, "brush/radiusShare", {minRadiusShare, maxRadiusShare}),
    row(&Setting::sharesRadius, "brush/sharesRadius"),
    row(&Setting::isSteady, "hand/steady"),
    row(&Setting::withoutAirbrush, "hand/withoutAirbrush"),
    row(&Setting::stabilizerLength, "hand/string", {minStabilizerLength, maxStabilizerLength}),
    row(&Setting::turnSpeed, "turntable/speed", {minTurn, maxTurn}),
    row(&Setting::turnsClockwise, "turntable/clockwise"),
    row(&Setting::showsReferences, "view/references"),
    row(&Setting::insertUse, "insert/combine", insertUses),
    keptRow(&Setting::swatches, "color/swatches"),
    keptRow(&Setting::printers, "print/printers"),
};

template <>
inline constexpr auto rows<ViewAppearance> = std::tuple{
    row(&ViewAppearance::material, "view/material", materials),
    row(&ViewAppearance::background, "view/background", backgrounds),
    row(&ViewAppearance::wireframe, "view/wireframe"),
    row(&ViewAppearance::flat, "view/flat"),
    row(&ViewAppearance::ground, "view/ground"),
    row(&ViewAppearance::scaleBar, "view/scaleBar"),
    row(&ViewAppearance::navigationCube, "view/navigationCube"),
    row(&ViewAppearance::caption, "view/caption"),
    row(&ViewAppearance::tint, "view/tint"),
    row(&ViewAppearance::cavity, "view/cavity"),
    row(&ViewAppearance::symmetryPlane, "view/symmetryPlane"),
};

template <>
inline constexpr auto rows<DrawingSettings> = std::tuple{
    row(&DrawingSettings::sides, "drawing/sides", drawnSides),
    row(&DrawingSettings::shaded, "drawing/shaded"),
    row(&DrawingSettings::dimensions, "drawing/dimensions"),
};

template <>
inline constexpr auto rows<FileBrowserSettings> = std::tuple{
    row(&FileBrowserSettings::folder, "files/folder"),
    row(&FileBrowserSettings::order, "files/order", fileOrders),
    row(&FileBrowserSettings::descending, "files/descending"),
    row(&FileBrowserSettings::pictureSize, "files/picture", {minPictureSize, maxPictureSize}),
};

template <>
inline constexpr auto rows<ExportSettings> = std::tuple{
    row(&ExportSettings::use, "export/use", exportUses),
    row(&ExportSettings::maxTriangles, "export/mostTriangles", {minExportTriangles, maxExportTriangles}),
    row(&ExportSettings::slices, "export/slices"),
    row(&ExportSettings::joinsParts, "export/joinsParts"),
};

template <>
inline constexpr auto rows<PrintSettings> = std::tuple{
    row(&PrintSettings::printer, "print/printer"),
    row(&PrintSettings::wall, "print/wall", {0, core::PrintLimits::maxWall}),
    row(&PrintSettings::overhang, "print/overhang", {0, 90}),
    row(&PrintSettings::picture, "print/picture", {0, 2}),
};

template <>
inline constexpr auto rows<StoredShapes> = std::tuple{
    row(&StoredShapes::alpha, "brush/alpha"),           row(&StoredShapes::alphaFollows, "brush/alphaFollows"),
    row(&StoredShapes::model, "brush/model"),           keptRow(&StoredShapes::alphas, "brush/alphaFiles"),
    keptRow(&StoredShapes::models, "brush/modelFiles"),
};

/// Values of a tool, stored in the tool's group (groupOf()).
template <>
inline constexpr auto rows<StoredTool> = std::tuple{
    row(&StoredTool::strength, "strength",
        {core::info(core::Parameter::Strength).min, core::info(core::Parameter::Strength).max}),
    row(&StoredTool::falloff, "falloff", {0, core::info(core::Parameter::Falloff).max}),
    row(&StoredTool::spacing, "spacing", {0, core::info(core::Parameter::Spacing).max}),
    row(&StoredTool::airbrush, "airbrush", {0, core::maxAirbrush}),
    row(&StoredTool::radiusShare, "radiusShare", {0, maxRadiusShare}),
    row(&StoredTool::anchored, "anchored"),
};

/// Alpha of a tool, stored in the tool's group (groupOf()).
template <>
inline constexpr auto rows<StoredToolAlpha> = std::tuple{
    row(&StoredToolAlpha::alpha, "alpha"),
    row(&StoredToolAlpha::alphaFollows, "alphaFollows"),
};

template <>
inline constexpr auto rows<InputPreferences> = std::tuple{
    row(&InputPreferences::pressureToStrength, "preferences/pressureToStrength"),
    row(&InputPreferences::pressureToRadius, "preferences/pressureToRadius"),
    row(&InputPreferences::altMovesView, "preferences/altMovesView"),
    row(&InputPreferences::penExponent, "preferences/penExponent", {minPenExponent, maxPenExponent}),
};

template <>
inline constexpr auto rows<ShortcutSettings> = std::tuple{
    row(&ShortcutSettings::preset, "keys/preset", shortcutPresets),
    row(&ShortcutSettings::custom, "keys/own"), // the key is followed by the action's id
};

template <>
inline constexpr auto rows<Preferences> = std::tuple{
    row(&Preferences::theme, "preferences/theme", themeChoices),
    row(&Preferences::language, "preferences/language", languages),
    row(&Preferences::textSize, "preferences/textSize", textSizes),
    row(&Preferences::reducesMotion, "preferences/calm"),
    row(&Preferences::keepsBackups, "preferences/keepsVersions"),
    row(&Preferences::opensObjectsAsParts, "preferences/objectsAsParts"),
    Part<Preferences, InputPreferences>{&Preferences::input},
    Part<Preferences, ShortcutSettings>{&Preferences::keys},
};
} // namespace stored
} // namespace ui
