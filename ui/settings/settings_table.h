#pragma once

#include "ui/settings/brush_settings.h"
#include "ui/settings/drawing_settings.h"
#include "ui/settings/export_settings.h"
#include "ui/settings/file_browser_settings.h"
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
/// The radii that make sense, as shares of the model's longest side. The least that the lattice takes is a little more.
inline constexpr double minRadiusShare = 0.002, maxRadiusShare = 0.5;

inline constexpr int minHistoryMegabytes = 16, maxHistoryMegabytes = 65536, defaultHistoryMegabytes = 512;

/// Clay, earth, slip, white, grey, black, and what children paint with.
QList<core::Rgb> firstSwatches();

/// Settings that are read and written one by one, with their defaults.
struct Setting
{
    QByteArray windowGeometry, windowState;
    QStringList panels; ///< of the side column: SideColumn::panelStates()
    bool showsToolNames = false;
    bool showsStartPage = true;                     ///< when the program begins without a file
    QStringList recentFiles;                        ///< paths, the latest first
    QString lastFolder;                             ///< of the last file opened or exported
    int historyMegabytes = defaultHistoryMegabytes; ///< memory that the undo steps may take
    double radiusShare = 0.1; ///< the brush's radius as a share of the model's longest side: fits the next model
    bool sharesRadius = true; ///< a change of tool leaves the radius as it is
    bool isSteady = false;
    QStringList withoutAirbrush;                       ///< names of tools
    double stabilizerLength = defaultStabilizerLength; ///< logical pixels
    double turnSpeed = defaultTurn;                    ///< of the turntable, degrees a second
    bool turnsClockwise = false;                       ///< seen from above
    bool showsReferences = true;
    QList<core::Rgb> swatches = firstSwatches();
    QList<PrinterPreset> printers = defaultPrinters(); ///< not empty
};

/// The shapes of the brush: what is chosen, and files that were, the latest first.
struct StoredShapes
{
    QString alpha; ///< a name of core::builtInAlphas(), or a path; empty: none
    bool alphaFollows = false;
    QString model;              ///< a path; empty: a ball
    QStringList alphas, models; ///< paths

    bool operator==(const StoredShapes&) const = default;
};

/// A tool's own values, without its alpha (ToolValues).
struct StoredTool
{
    double strength = 1, falloff = 4;
    double spacing = defaultSpacing;
    double airbrush = core::defaultAirbrush; ///< dabs a second; 0: none
    double radiusShare = 0;                  ///< 0: the tool never had a radius of its own
    bool anchored = false;
};

/// The alpha of a tool.
struct StoredToolAlpha
{
    QString alpha; ///< as StoredShapes::alpha
    bool alphaFollows = false;

    bool operator==(const StoredToolAlpha&) const = default;
};

/// The choices of the print check.
struct PrintSettings
{
    QString printer;      ///< by name
    double wall = 0.8;    ///< mm; thinner is marked
    double overhang = 45; ///< degrees; more is marked
    int picture = 1;      ///< 1 and core::PrintPicture; 0: the model shows nothing
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

/// The valid values of T: a range, the words of an enumeration, or anything.
template <class T>
using Valid = std::conditional_t<std::is_enum_v<T>, std::span<const Named<T>>,
                                 std::conditional_t<std::is_arithmetic_v<T>, Range, Anything>>;

/// The effect of Settings::reset().
enum class Reset { ToDefault, Keep };

/// The place where one member of S is stored. A reset keeps what the user made.
template <class S, class T> struct Row
{
    T S::*member;
    const char* key;
    Valid<T> valid;
    Reset reset;
};

/// A member of S that has rows of its own.
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

/// The table of all settings, by the struct that they belong to. Defaults are those of the struct.
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

/// Stored in a group for each tool.
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

/// Stored in the same groups.
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
    row(&ShortcutSettings::custom, "keys/own"), // and the action's id
};

template <>
inline constexpr auto rows<Preferences> = std::tuple{
    row(&Preferences::theme, "preferences/theme", themeChoices),
    row(&Preferences::language, "preferences/language", languages),
    row(&Preferences::textSize, "preferences/textSize", textSizes),
    row(&Preferences::reducesMotion, "preferences/calm"),
    row(&Preferences::keepsBackups, "preferences/keepsVersions"),
    Part<Preferences, InputPreferences>{&Preferences::input},
    Part<Preferences, ShortcutSettings>{&Preferences::keys},
};
} // namespace stored
} // namespace ui
