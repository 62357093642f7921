#pragma once

#include "ui/settings/brush_settings.h"
#include "ui/settings/drawing_settings.h"
#include "ui/settings/export_settings.h"
#include "ui/settings/file_browser_settings.h"
#include "ui/settings/preferences.h"
#include "ui/settings/printer_presets.h"
#include "ui/settings/reference_placement.h"
#include "ui/settings/turntable_settings.h"
#include "ui/settings/view_appearance.h"

#include "core/geometry/geometry.h"
#include "core/stroke/tool.h"

#include <QByteArray>
#include <QList>
#include <QSettings>
#include <QString>
#include <QStringList>

#include <functional>
#include <vector>

namespace ui
{
/// The radii that make sense, as shares of the model's longest side. The least that the lattice takes is a little more.
inline constexpr double minRadiusShare = 0.002, maxRadiusShare = 0.5;

/// The spacing of a new user's brush, in radii: dense enough for an even furrow, wide enough that a slow hand does not
/// dig a hole.
inline constexpr double defaultSpacing = 0.25;

inline constexpr core::Parameter storedParameters[] = {core::Parameter::Strength, core::Parameter::Falloff,
                                                       core::Parameter::Detail, core::Parameter::Spacing};

inline constexpr int minHistoryMegabytes = 16, maxHistoryMegabytes = 65536, defaultHistoryMegabytes = 512;

/// A reference image: a local path, empty where there is none, and how it stands.
struct StoredReference
{
    QString path;
    ReferencePlacement placement;

    bool operator==(const StoredReference&) const = default;
};

/// Of the brush: what is chosen, and files that were, the latest first.
struct StoredShapes
{
    QString alpha; ///< a name of core::builtInAlphas(), or a path; empty: none
    bool alphaFollows = false;
    QString model;              ///< a path; empty: a ball
    QStringList alphas, models; ///< paths

    bool operator==(const StoredShapes&) const = default;
};

/// Of the print check: whose bed, what is too thin and what leans out too far, and what the model shows (0: nothing).
struct PrintSettings
{
    QString printer;      ///< by name
    double wall = 0.8;    ///< mm
    double overhang = 45; ///< degrees
    int picture = 1;      ///< 1 and core::PrintPicture
};

/// Every stored preference: its key, type and default in one place. A missing or broken entry gives the default. The
/// program sets organisation and application name before. Gui thread.
class Settings
{
public:
    QByteArray windowGeometry() const;
    void setWindowGeometry(const QByteArray& geometry);
    QByteArray windowState() const;
    void setWindowState(const QByteArray& state);

    /// Paths, the latest first.
    QStringList recentFiles() const;
    void addRecentFile(const QString& path);
    void setRecentFiles(const QStringList& paths);
    /// The folder of the last file opened or exported; the user's home if there is none, or it is gone.
    QString lastFolder() const;
    void setLastFolder(const QString& folder);

    /// Of the files panel. A folder that is gone gives lastFolder().
    FileBrowserSettings files() const;
    void setFiles(const FileBrowserSettings& options);

    /// So much memory the undo steps may take.
    int historyMegabytes() const;
    void setHistoryMegabytes(int megabytes);

    /// How the 2D preview shows the model.
    DrawingSettings drawing() const;
    void setDrawing(const DrawingSettings& options);

    /// As it was agreed to last.
    ExportSettings exporting() const;
    void setExporting(const ExportSettings& options);

    PrintSettings print() const;
    void setPrint(const PrintSettings& options);
    /// Not empty: the usual ones where none are stored.
    QList<PrinterPreset> printers() const;
    void setPrinters(const QList<PrinterPreset>& printers);

    /// Of the brush; the radius is kept as a share instead.
    double value(core::Parameter parameter) const;
    void setValue(core::Parameter parameter, double value);
    /// The radius as a share of the model's longest side, so that it fits the next model too.
    double radiusShare() const;
    void setRadiusShare(double share);

    StoredShapes shapes() const;
    void setShapes(const StoredShapes& shapes);

    Preferences preferences() const;
    void setPreferences(const Preferences& preferences);

    /// Everything to its default but what a person made: recent files and folder, swatches, reference images, printers.
    /// Then all are called that asked for it, in that order, to take up what holds now.
    void reset();
    void onReset(std::function<void()> applySettings);

    ViewAppearance appearance() const;
    void setAppearance(const ViewAppearance& appearance);

    /// Whether the start page is shown when the program begins without a file.
    bool showsStartPage() const;
    void setShowsStartPage(bool shows);

    /// Whether strokes are steady, and the length of the stabilizer in logical pixels.
    bool isSteady() const;
    void setSteady(bool steady);
    double stabilizerLength() const;
    void setStabilizerLength(double pixels);

    /// Of the turntable, degrees a second; seen from above.
    double turnSpeed() const;
    void setTurnSpeed(double speed);
    bool turnsClockwise() const;
    void setTurnsClockwise(bool clockwise);

    StoredReference reference(ViewSide side) const;
    void setReference(ViewSide side, const StoredReference& reference);
    bool showsReferences() const;
    void setShowsReferences(bool shows);

    /// Colours at hand, in order; a first choice where none were ever stored. Broken ones are left out.
    QList<core::Rgb> swatches() const;
    void setSwatches(const QList<core::Rgb>& swatches);

private:
    QSettings m_settings;
    std::vector<std::function<void()>> m_onReset;
};
} // namespace ui
