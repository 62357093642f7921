#include "ui/files/thumbnail_cache.h"

#include <QDateTime>
#include <QDir>
#include <QFile>
#include <QImageReader>
#include <QImageWriter>
#include <QSaveFile>
#include <QStandardPaths>

namespace ui
{
namespace
{
const QString verticesText = QStringLiteral("Fettle.Vertices"), versionText = QStringLiteral("Fettle.Version");
const QString version = QStringLiteral("1"); ///< version of the drawing; pictures of another version are ignored
} // namespace

ThumbnailCache::ThumbnailCache(const QString& folder, int capacity) : m_folder(folder), m_capacity(capacity) {}

QString ThumbnailCache::defaultFolder()
{
    return QStandardPaths::writableLocation(QStandardPaths::CacheLocation) + QStringLiteral("/thumbnails");
}

QString ThumbnailCache::pathOf(const QByteArray& key) const
{
    return QStringLiteral("%1/%2.png").arg(m_folder, QString::fromLatin1(key));
}

std::optional<Thumbnail> ThumbnailCache::find(const QByteArray& key) const
{
    QFile file(pathOf(key));
    if (!file.open(QIODevice::ReadOnly))
        return std::nullopt;
    const QImage picture = QImageReader(&file, "png").read();
    bool isNumber = false;
    const qint64 vertices = picture.text(verticesText).toLongLong(&isNumber);
    if (picture.size() != QSize(thumbnailPixels, thumbnailPixels) || picture.text(versionText) != version || !isNumber)
        return std::nullopt;
    file.setFileTime(QDateTime::currentDateTimeUtc(), QFileDevice::FileModificationTime);
    return Thumbnail{picture.convertToFormat(QImage::Format_ARGB32_Premultiplied), vertices, {}};
}

void ThumbnailCache::store(const QByteArray& key, const Thumbnail& thumbnail)
{
    evictOldest();
    QSaveFile file(pathOf(key));
    if (!file.open(QIODevice::WriteOnly))
        return;
    QImageWriter writer(&file, "png");
    writer.setText(verticesText, QString::number(thumbnail.vertices));
    writer.setText(versionText, version);
    if (writer.write(thumbnail.picture) && file.commit())
        ++m_count;
}

/// Deletes a tenth of the pictures at once if the cache is full, so that the folder is not listed for each new picture.
void ThumbnailCache::evictOldest()
{
    QDir folder(m_folder);
    if (m_count < 0 && folder.mkpath(QStringLiteral(".")))
        m_count = static_cast<int>(folder.entryList({QStringLiteral("*.png")}, QDir::Files).size());
    if (m_count < m_capacity)
        return;
    const QStringList latestFirst = folder.entryList({QStringLiteral("*.png")}, QDir::Files, QDir::Time);
    const qsizetype kept = m_capacity - qMax(1, m_capacity / 10);
    for (const QString& name : latestFirst.mid(kept))
        folder.remove(name);
    m_count = static_cast<int>(qMin(kept, latestFirst.size()));
}
} // namespace ui
