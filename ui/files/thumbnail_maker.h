#pragma once

#include "ui/files/file_entry.h"
#include "ui/files/thumbnail_cache.h"
#include "ui/util/thread_mailbox.h"

#include <QHash>
#include <QList>
#include <QObject>

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <stop_token>
#include <thread>

namespace core
{
struct ModelThumbnail;
}

namespace ui
{
/// Converts the picture; the result is a copy.
QImage toImage(const core::ModelThumbnail& picture);

/// Draws pictures of model files on its own low-priority thread. A cache returns pictures drawn before, whatever the
/// file's name. Thread: gui; all functions except the destructor return at once.
class ThumbnailMaker : public QObject
{
    Q_OBJECT

public:
    explicit ThumbnailMaker(const QString& cacheFolder = ThumbnailCache::defaultFolder(), QObject* parent = nullptr);
    /// Waits for the thread; up to about 100 ms.
    ~ThumbnailMaker() override;

    /// Requests pictures of these files in this order and cancels earlier requests. If a file that is
    /// not among them is being drawn, drawing it stops within about 100 ms.
    void request(QList<FileEntry> files);

    /// Returns the number of pictures drawn because the cache did not contain them. Thread: any.
    int drawn() const { return m_drawn; }

Q_SIGNALS:
    /// The picture of a requested file is ready; emitted once for each file whose request is not cancelled. If the file
    /// cannot be read, the thumbnail contains the reason.
    void made(const ui::FileEntry& file, const ui::Thumbnail& thumbnail);

private:
    void run();
    std::optional<Thumbnail> make(const FileEntry& file, const std::stop_token& stop);
    Thumbnail draw(const FileEntry& file, const std::stop_token& stop);
    QByteArray keyOf(const FileEntry& file, const std::stop_token& stop);

    ThreadMailbox m_mail;
    std::mutex m_mutex; ///< guards the next five members
    std::condition_variable m_wake;
    QList<FileEntry> m_requested;
    FileEntry m_present; ///< file whose picture is being made
    std::stop_source m_stop;
    bool m_isEnding = false;

    std::atomic<int> m_drawn = 0;
    ThumbnailCache m_cache;              ///< used by the background thread only, as is m_keys
    QHash<FileEntry, QByteArray> m_keys; ///< keys of files that were read

    std::thread m_thread; ///< last member: its function uses the other members
};
} // namespace ui
