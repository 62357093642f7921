#include "app/headset/headset_files.h"

#include "ui/settings/settings.h"

#include <QDir>
#include <QFileInfo>

#include <algorithm>

namespace app
{
namespace
{
constexpr int listDelayMs = 300; ///< a folder changes several times while a file is being written

vr::FileTile tileOf(const ui::FileEntry& entry)
{
    return {entry.path, QFileInfo(entry.path).fileName(), {}, false};
}
} // namespace

HeadsetFiles::HeadsetFiles(QObject* parent) : QObject(parent)
{
    m_listTimer.setSingleShot(true);
    m_listTimer.setInterval(listDelayMs);
    connect(&m_listTimer, &QTimer::timeout, this, &HeadsetFiles::list);
    connect(&m_watcher, &QFileSystemWatcher::directoryChanged, &m_listTimer, qOverload<>(&QTimer::start));
}

HeadsetFiles::~HeadsetFiles()
{
    m_listing.request_stop();
}

QString HeadsetFiles::folderOf(const QString& path)
{
    return path.isEmpty() ? ui::Settings().lastFolder() : QFileInfo(path).absolutePath();
}

void HeadsetFiles::watch(const QString& folder)
{
    if (folder == m_folder)
        return;
    stop();
    m_folder = folder;
    m_watcher.addPath(folder);
    list();
}

void HeadsetFiles::stop()
{
    m_listing.request_stop();
    m_listTimer.stop();
    m_maker.reset();
    if (const QStringList watched = m_watcher.directories(); !watched.isEmpty())
        m_watcher.removePaths(watched);
    m_folder.clear();
    m_entries.clear();
    m_tiles.clear();
}

QString HeadsetFiles::name() const
{
    const QString name = QDir(m_folder).dirName();
    return name.isEmpty() ? QDir::toNativeSeparators(m_folder) : name; // a root folder has no name
}

void HeadsetFiles::list()
{
    m_listing.request_stop();
    m_listing = {};
    const std::stop_token stop = m_listing.get_token();
    m_disk.run([folder = m_folder, stop] { return ui::FileJobs::list(folder, stop); },
               [this, stop](const ui::FolderContent& content) {
                   if (!stop.stop_requested())
                       setContent(content);
               });
}

/// Sets the listed files. Unchanged files keep their pictures.
void HeadsetFiles::setContent(const ui::FolderContent& content)
{
    QList<ui::FileEntry> entries = content.entries;
    entries.removeIf([](const ui::FileEntry& entry) { return entry.isFolder; });
    std::ranges::sort(entries, [](const ui::FileEntry& a, const ui::FileEntry& b) {
        return a.modifiedMs != b.modifiedMs ? a.modifiedMs > b.modifiedMs : a.path < b.path;
    });
    entries = entries.mid(0, maxFiles);
    QList<vr::FileTile> tiles;
    QList<ui::FileEntry> missing;
    for (const ui::FileEntry& entry : entries) {
        const qsizetype known = m_entries.indexOf(entry);
        tiles << (known < 0 ? tileOf(entry) : m_tiles[known]);
        if (tiles.last().picture.isNull() && !tiles.last().isBroken)
            missing << entry;
    }
    m_entries = entries;
    m_tiles = tiles;
    if (!m_maker) {
        m_maker = std::make_unique<ui::ThumbnailMaker>();
        connect(m_maker.get(), &ui::ThumbnailMaker::made, this, &HeadsetFiles::setThumbnail);
    }
    m_maker->request(missing);
    Q_EMIT changed();
}

void HeadsetFiles::setThumbnail(const ui::FileEntry& file, const ui::Thumbnail& thumbnail)
{
    const qsizetype i = m_entries.indexOf(file);
    if (i < 0)
        return;
    m_tiles[i].picture = thumbnail.picture;
    m_tiles[i].isBroken = thumbnail.picture.isNull();
    Q_EMIT changed();
}
} // namespace app
