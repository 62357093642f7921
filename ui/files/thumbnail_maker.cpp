#include "ui/files/thumbnail_maker.h"

#include "ui/files/file_jobs.h"
#include "ui/util/error_messages.h"

#include "core/drawing/model_thumbnail.h"
#include "core/io/mesh_io.h"
#include "core/util/thread_priority.h"

#include <QCryptographicHash>
#include <QFile>
#include <QFileInfo>

#include <new>

namespace ui
{
namespace
{
/// Files above maxHashedBytes get no key; the readers refuse them anyway.
constexpr qint64 hashChunkBytes = 1 << 20, maxHashedBytes = qint64(1) << 31;
constexpr qsizetype maxCachedKeys = 20'000;
} // namespace

QImage toImage(const core::ModelThumbnail& picture)
{
    const QImage rgba(reinterpret_cast<const uchar*>(picture.rgba.data()), picture.width, picture.height,
                      QImage::Format_RGBA8888_Premultiplied);
    return rgba.convertToFormat(QImage::Format_ARGB32_Premultiplied);
}

ThumbnailMaker::ThumbnailMaker(const QString& cacheFolder, QObject* parent)
    : QObject(parent)
    , m_cache(cacheFolder)
    , m_thread([this] { run(); })
{}

ThumbnailMaker::~ThumbnailMaker()
{
    {
        const std::lock_guard lock(m_mutex);
        m_isEnding = true;
        m_stop.request_stop();
    }
    m_wake.notify_all();
    m_thread.join();
}

void ThumbnailMaker::request(QList<FileEntry> files)
{
    {
        const std::lock_guard lock(m_mutex);
        if (files.contains(m_present))
            files.removeAll(m_present);
        else
            m_stop.request_stop();
        m_requested = std::move(files);
    }
    m_wake.notify_all();
}

void ThumbnailMaker::run()
{
    core::lowerThreadPriority(core::ThreadPriority::Idle);
    std::unique_lock lock(m_mutex);
    for (;;) {
        m_wake.wait(lock, [this] { return m_isEnding || !m_requested.empty(); });
        if (m_isEnding)
            return;
        m_present = m_requested.takeFirst();
        m_stop = {};
        const std::stop_token stop = m_stop.get_token();
        lock.unlock();
        std::optional<Thumbnail> thumbnail = make(m_present, stop);
        lock.lock();
        FileEntry file = std::exchange(m_present, {});
        if (thumbnail && !stop.stop_requested())
            m_mail.post(
                [this, file = std::move(file), thumbnail = *std::move(thumbnail)] { Q_EMIT made(file, thumbnail); });
    }
}

/// Returns nullopt if stopped.
std::optional<Thumbnail> ThumbnailMaker::make(const FileEntry& file, const std::stop_token& stop)
{
    try {
        const QByteArray key = keyOf(file, stop);
        if (!key.isEmpty())
            if (const std::optional<Thumbnail> known = m_cache.find(key))
                return known;
        const Thumbnail thumbnail = draw(file, stop);
        if (!key.isEmpty() && FileJobs::entryOf(file.path) == file) // otherwise the file changed while it was read
            m_cache.store(key, thumbnail);
        return thumbnail;
    } catch (const core::ReadingCancelled&) {
        return std::nullopt;
    } catch (const core::FileError& error) {
        return Thumbnail{{}, -1, ErrorMessages::sentence(error)};
    } catch (const std::bad_alloc&) {
        return Thumbnail{{}, -1, tr("%1: there is not enough memory for its picture.").arg(file.path)};
    }
}

Thumbnail ThumbnailMaker::draw(const FileEntry& file, const std::stop_token& stop)
{
    const core::TriangleMesh mesh = core::readMesh(file.path.toStdU16String(), {.stop = stop});
    const std::optional<core::ModelThumbnail> picture = core::drawThumbnail(mesh, thumbnailPixels, stop);
    if (!picture)
        throw core::ReadingCancelled();
    ++m_drawn;
    return {toImage(*picture), static_cast<qint64>(mesh.points.size()), {}};
}

/// Returns a hash of the file's content and suffix, which selects the reader. Empty if the file cannot be read.
QByteArray ThumbnailMaker::keyOf(const FileEntry& file, const std::stop_token& stop)
{
    if (const auto known = m_keys.constFind(file); known != m_keys.constEnd())
        return *known;
    QFile bytes(file.path);
    if (file.size > maxHashedBytes || !bytes.open(QIODevice::ReadOnly))
        return {};
    QCryptographicHash hash(QCryptographicHash::Sha1);
    hash.addData(QFileInfo(file.path).suffix().toLower().toUtf8());
    QByteArray part;
    do {
        if (stop.stop_requested())
            throw core::ReadingCancelled();
        part = bytes.read(hashChunkBytes);
        hash.addData(part);
    } while (!part.isEmpty());
    if (bytes.error() != QFileDevice::NoError)
        return {};
    if (m_keys.size() >= maxCachedKeys)
        m_keys.clear();
    return *m_keys.insert(file, hash.result().toHex());
}
} // namespace ui
