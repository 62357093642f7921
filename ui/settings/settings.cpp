#include "ui/settings/settings.h"

#include "ui/settings/stored_values.h"

#include <QDir>

#include <algorithm>

namespace ui
{
namespace
{
constexpr qsizetype maxRecentFiles = 10;

const QString geometryKey = QStringLiteral("window/geometry");
const QString stateKey = QStringLiteral("window/state");
const QString historyKey = QStringLiteral("history/megabytes");
const QString recentKey = QStringLiteral("files/recent");
const QString folderKey = QStringLiteral("files/lastFolder");
const QString shownFolderKey = QStringLiteral("files/folder");
const QString fileOrderKey = QStringLiteral("files/order");
const QString filesDescendingKey = QStringLiteral("files/descending");
const QString filePictureKey = QStringLiteral("files/picture");
const QString exportUseKey = QStringLiteral("export/use");
const QString exportTrianglesKey = QStringLiteral("export/mostTriangles");
const QString exportSlicesKey = QStringLiteral("export/slices");
const QString printerKey = QStringLiteral("print/printer");
const QString printersKey = QStringLiteral("print/printers");
const QString printWallKey = QStringLiteral("print/wall");
const QString printOverhangKey = QStringLiteral("print/overhang");
const QString printPictureKey = QStringLiteral("print/picture");
const QString startPageKey = QStringLiteral("start/page");
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
    return m_settings.value(recentKey).toStringList().mid(0, maxRecentFiles);
}

void Settings::addRecentFile(const QString& path)
{
    QStringList paths = recentFiles();
    paths.removeAll(path);
    paths.prepend(path);
    setRecentFiles(paths.mid(0, maxRecentFiles));
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

FileBrowserSettings Settings::files() const
{
    const QString folder = m_settings.value(shownFolderKey).toString();
    const bool isThere = !folder.isEmpty() && QDir(folder).exists();
    return {isThere ? folder : lastFolder(), stored::choice(m_settings, fileOrderKey, fileOrders, FileOrder::Name),
            stored::yesNo(m_settings, filesDescendingKey, false),
            static_cast<int>(stored::number(m_settings, filePictureKey, minPicture, maxPicture, defaultPicture))};
}

void Settings::setFiles(const FileBrowserSettings& options)
{
    m_settings.setValue(shownFolderKey, options.folder);
    m_settings.setValue(fileOrderKey, stored::wordFor(options.order, fileOrders));
    m_settings.setValue(filesDescendingKey, options.descending);
    m_settings.setValue(filePictureKey, options.picture);
}

int Settings::historyMegabytes() const
{
    return static_cast<int>(
        stored::number(m_settings, historyKey, minHistoryMegabytes, maxHistoryMegabytes, defaultHistoryMegabytes));
}

void Settings::setHistoryMegabytes(int megabytes)
{
    m_settings.setValue(historyKey, megabytes);
}

ExportSettings Settings::exporting() const
{
    const double max = stored::number(m_settings, exportTrianglesKey, minExportTriangles, maxExportTriangles, 0);
    return {stored::choice(m_settings, exportUseKey, exportUses, ExportUse::Print), static_cast<quint64>(max),
            stored::yesNo(m_settings, exportSlicesKey, false)};
}

void Settings::setExporting(const ExportSettings& options)
{
    m_settings.setValue(exportUseKey, stored::wordFor(options.use, exportUses));
    m_settings.setValue(exportTrianglesKey, options.maxTriangles);
    m_settings.setValue(exportSlicesKey, options.slices);
}

PrintSettings Settings::print() const
{
    const PrintSettings defaults;
    return {m_settings.value(printerKey).toString(),
            stored::number(m_settings, printWallKey, 0, core::PrintLimits::maxWall, defaults.wall),
            stored::number(m_settings, printOverhangKey, 0, 90, defaults.overhang),
            static_cast<int>(stored::number(m_settings, printPictureKey, 0, 2, defaults.picture))};
}

void Settings::setPrint(const PrintSettings& options)
{
    m_settings.setValue(printerKey, options.printer);
    m_settings.setValue(printWallKey, options.wall);
    m_settings.setValue(printOverhangKey, options.overhang);
    m_settings.setValue(printPictureKey, options.picture);
}

QList<PrinterPreset> Settings::printers() const
{
    const QList<PrinterPreset> stored = printersOf(m_settings.value(printersKey).toStringList());
    return stored.isEmpty() ? defaultPrinters() : stored;
}

void Settings::setPrinters(const QList<PrinterPreset>& printers)
{
    m_settings.setValue(printersKey, toLines(printers));
}

void Settings::reset()
{
    for (const QString& key : m_settings.allKeys())
        if (key != recentKey && key != folderKey && key != stored::swatchesKey && key != printersKey &&
            key != stored::alphaFilesKey && key != stored::modelFilesKey && !key.startsWith(stored::referenceKeys))
            m_settings.remove(key);
    for (const auto& applySettings : m_onReset)
        applySettings();
}

void Settings::onReset(std::function<void()> applySettings)
{
    m_onReset.push_back(std::move(applySettings));
}

bool Settings::showsStartPage() const
{
    return stored::yesNo(m_settings, startPageKey, true);
}

void Settings::setShowsStartPage(bool shows)
{
    m_settings.setValue(startPageKey, shows);
}
} // namespace ui
