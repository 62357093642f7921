#pragma once

#include "ui/util/background_thread.h"

#include <QListWidget>

#include <memory>

namespace ui
{
class Settings;
class ThumbnailMaker;
struct FileEntry;
struct Thumbnail;

/// The files that were open before, with their pictures. Asks the disk and draws in other threads. Thread: gui.
class RecentFiles : public QListWidget
{
    Q_OBJECT

public:
    /// The settings must outlive it.
    explicit RecentFiles(const Settings* settings, QWidget* parent = nullptr);
    ~RecentFiles() override;

    /// Lists the files of the settings; those that turn out to be gone leave the list.
    void fill();

Q_SIGNALS:
    void chosen(const QString& path);

private:
    void take(const QList<FileEntry>& there);
    void setPicture(const FileEntry& file, const Thumbnail& thumbnail);
    QListWidgetItem* itemOf(const QString& path) const;

    const Settings* m_settings;
    std::unique_ptr<ThumbnailMaker> m_maker; ///< from the first file on
    int m_fills = 0;
    BackgroundThread m_disk; ///< last
};
} // namespace ui
