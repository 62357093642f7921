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
/// Returns a copy of the picture.
QImage toImage(const core::ModelThumbnail& picture);

/// Makes pictures of model files on a thread of its own, with the lowest priority. A picture that was drawn before
/// comes from a cache, whatever the file's name. Thread: gui; all functions return at once, except the destructor.
class ThumbnailMaker : public QObject
{
    Q_OBJECT

public:
    explicit ThumbnailMaker(const QString& cacheFolder = ThumbnailCache::defaultFolder(), QObject* parent = nullptr);
    /// Waits for the thread, at most some 100 ms.
    ~ThumbnailMaker() override;

    /// Requests pictures of these files, in this order, instead of those requested before. A picture that is being made
    /// of another file is given up within some 100 ms.
    void request(QList<FileEntry> files);

    /// Returns the number of pictures that were drawn, since the cache did not have them. Thread: any.
    int drawn() const { return m_drawn; }

Q_SIGNALS:
    /// Emitted once for each requested file. If the file cannot be read, or is gone, the thumbnail has the reason.
    void made(const ui::FileEntry& file, const ui::Thumbnail& thumbnail);

private:
    void run();
    std::optional<Thumbnail> make(const FileEntry& file, const std::stop_token& stop);
    Thumbnail draw(const FileEntry& file, const std::stop_token& stop);
    QByteArray keyOf(const FileEntry& file, const std::stop_token& stop);

    ThreadMailbox m_mail;
    std::mutex m_mutex; ///< guards the next five
    std::condition_variable m_wake;
    QList<FileEntry> m_requested;
    FileEntry m_present; ///< being made
    std::stop_source m_stop;
    bool m_isEnding = false;

    std::atomic<int> m_drawn = 0;
    ThumbnailCache m_cache;              ///< used by the thread alone, as the next
    QHash<FileEntry, QByteArray> m_keys; ///< of files that were read

    std::thread m_thread; ///< last: it uses the others
};
} // namespace ui
