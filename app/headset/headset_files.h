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
/// The models of a folder with their pictures, as the headset shows them. The disk is asked and pictures are made in
/// other threads, and only while somebody looks. Thread: gui.
class HeadsetFiles : public QObject
{
    Q_OBJECT

public:
    static constexpr qsizetype maxFiles = 120; ///< the latest

    explicit HeadsetFiles(QObject* parent = nullptr);
    ~HeadsetFiles() override;

    /// The folder of the model with that file; of a model without a file, the last folder used.
    static QString folderOf(const QString& path);

    /// Lists that folder from now on, and watches it for changes.
    void watch(const QString& folder);
    void stop();

    /// The latest first; a picture comes when it is made.
    const QList<vr::FileTile>& tiles() const { return m_tiles; }
    /// Of the folder, for people.
    QString name() const;

Q_SIGNALS:
    void changed();

private:
    void list();
    void setContent(const ui::FolderContent& content);
    void setThumbnail(const ui::FileEntry& file, const ui::Thumbnail& thumbnail);

    QString m_folder; ///< empty: no folder is watched
    QList<ui::FileEntry> m_entries;
    QList<vr::FileTile> m_tiles; ///< of the entries
    QFileSystemWatcher m_watcher;
    QTimer m_listTimer;
    std::unique_ptr<ui::ThumbnailMaker> m_maker;
    std::stop_source m_listing;
    ui::BackgroundThread m_disk; ///< last
};
} // namespace app
