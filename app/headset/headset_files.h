#pragma once

#include "ui/files/file_jobs.h"
#include "ui/files/thumbnail_maker.h"
#include "ui/util/background_thread.h"

#include "vr/panels/panel_content.h"

#include <QFileSystemWatcher>
#include <QTimer>

#include <memory>

namespace app
{
/// The models of a folder and their pictures, shown in the headset. The disk is read and pictures are made on other
/// threads, only while a folder is watched. Thread: gui.
class HeadsetFiles : public QObject
{
    Q_OBJECT

public:
    static constexpr qsizetype maxFiles = 120; ///< at most this number of files is shown: the latest ones

    explicit HeadsetFiles(QObject* parent = nullptr);
    ~HeadsetFiles() override;

    /// Returns the folder of a model's file; for an empty path, the folder used last.
    static QString folderOf(const QString& path);

    /// Lists the folder now and whenever it changes.
    void watch(const QString& folder);
    void stop();

    /// Returns the files, the latest first. Their pictures are added when they are ready.
    const QList<vr::FileTile>& tiles() const { return m_tiles; }
    /// Returns the display name of the folder.
    QString name() const;

Q_SIGNALS:
    void changed();

private:
    void list();
    void setContent(const ui::FolderContent& content);
    void setThumbnail(const ui::FileEntry& file, const ui::Thumbnail& thumbnail);

    QString m_folder; ///< empty: no folder is watched
    QList<ui::FileEntry> m_entries;
    QList<vr::FileTile> m_tiles; ///< one for each of m_entries
    QFileSystemWatcher m_watcher;
    QTimer m_listTimer;
    std::unique_ptr<ui::ThumbnailMaker> m_maker;
    std::stop_source m_listing;
    ui::BackgroundThread m_disk; ///< last member: its destructor waits for jobs that use the other members
};
} // namespace app
