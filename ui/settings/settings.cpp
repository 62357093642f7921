#include "ui/settings/settings.h"

#include "ui/settings/stored_values.h"

#include <QDir>

#include <algorithm>

namespace ui
{
namespace
{
constexpr qsizetype mostRecentFiles = 10;

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
    return {isThere ? folder : lastFolder(), stored::choice(m_settings, fileOrderKey, fileOrders, FileOrder::Name),
            stored::yesNo(m_settings, filesDescendingKey, false),
            static_cast<int>(stored::number(m_settings, filePictureKey, minPicture, maxPicture, defaultPicture))};
}

void Settings::setFiles(const FilesChoice& choice)
{
    m_settings.setValue(shownFolderKey, choice.folder);
    m_settings.setValue(fileOrderKey, stored::wordFor(choice.order, fileOrders));
    m_settings.setValue(filesDescendingKey, choice.descending);
    m_settings.setValue(filePictureKey, choice.picture);
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

ExportChoice Settings::exporting() const
{
    const double most = stored::number(m_settings, exportTrianglesKey, leastExportTriangles, mostExportTriangles, 0);
    return {stored::choice(m_settings, exportUseKey, exportUses, ExportUse::Print), static_cast<quint64>(most),
            stored::yesNo(m_settings, exportSlicesKey, false)};
}

void Settings::setExporting(const ExportChoice& choice)
{
    m_settings.setValue(exportUseKey, stored::wordFor(choice.use, exportUses));
    m_settings.setValue(exportTrianglesKey, choice.mostTriangles);
    m_settings.setValue(exportSlicesKey, choice.slices);
}

PrintChoice Settings::print() const
{
    const PrintChoice usual;
    return {m_settings.value(printerKey).toString(),
            stored::number(m_settings, printWallKey, 0, core::PrintLimits::maxWall, usual.wall),
            stored::number(m_settings, printOverhangKey, 0, 90, usual.overhang),
            static_cast<int>(stored::number(m_settings, printPictureKey, 0, 2, usual.picture))};
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

void Settings::reset()
{
    for (const QString& key : m_settings.allKeys())
        if (key != recentKey && key != folderKey && key != stored::swatchesKey && key != printersKey &&
            key != stored::alphaFilesKey && key != stored::modelFilesKey && !key.startsWith(stored::referenceKeys))
            m_settings.remove(key);
    for (const auto& takeUp : m_onReset)
        takeUp();
}

void Settings::onReset(std::function<void()> takeUp)
{
    m_onReset.push_back(std::move(takeUp));
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
