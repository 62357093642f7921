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

/// A list of recently opened files with pictures. Reads the disk and draws on other threads. Thread: gui.
class RecentFiles : public QListWidget
{
    Q_OBJECT

public:
    /// Precondition: `settings` outlives the list.
    explicit RecentFiles(const Settings* settings, QWidget* parent = nullptr);
    ~RecentFiles() override;

    /// Lists the recent files of the settings; files that do not exist are then removed from the list.
    void fill();

Q_SIGNALS:
    void chosen(const QString& path);

private:
    void take(const QList<FileEntry>& there);
    void setPicture(const FileEntry& file, const Thumbnail& thumbnail);
    QListWidgetItem* itemOf(const QString& path) const;

    const Settings* m_settings;
    std::unique_ptr<ThumbnailMaker> m_maker; ///< created for the first file
    int m_fills = 0;
    BackgroundThread m_disk; ///< last member: destroyed first, because its jobs use the other members
};
} // namespace ui
