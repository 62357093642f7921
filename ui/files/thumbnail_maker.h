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
/// A copy.
QImage toImage(const core::ModelThumbnail& picture);

/// Makes pictures of model files on one thread of its own, which yields to all others; what was drawn before, under
/// whatever name, comes from a cache. Gui thread; all returns at once.
class ThumbnailMaker : public QObject
{
    Q_OBJECT

public:
    explicit ThumbnailMaker(const QString& cacheFolder = ThumbnailCache::defaultFolder(), QObject* parent = nullptr);
    /// Takes at most some 100 ms.
    ~ThumbnailMaker() override;

    /// These, in this order, and nothing that was wanted before: a picture that is being made for another file is given
    /// up (within some 100 ms).
    void request(QList<FileEntry> files);

    /// So many were in no cache. Any thread.
    int drawn() const { return m_drawn; }

Q_SIGNALS:
    /// Once for each that is wanted. A file that cannot be read, or is gone meanwhile, comes with the reason.
    void made(const ui::FileEntry& file, const ui::Thumbnail& thumbnail);

private:
    void run();
    std::optional<Thumbnail> make(const FileEntry& file, const std::stop_token& stop);
    Thumbnail draw(const FileEntry& file, const std::stop_token& stop);
    QByteArray keyOf(const FileEntry& file, const std::stop_token& stop);

    ThreadMailbox m_mail;
    std::mutex m_mutex; ///< of the next five
    std::condition_variable m_wake;
    QList<FileEntry> m_requested;
    FileEntry m_present; ///< being made
    std::stop_source m_stop;
    bool m_isEnding = false;

    std::atomic<int> m_drawn = 0;
    ThumbnailCache m_cache;              ///< of the thread, as the next
    QHash<FileEntry, QByteArray> m_keys; ///< of files that were read

    std::thread m_thread; ///< last: it uses the others
};
} // namespace ui
