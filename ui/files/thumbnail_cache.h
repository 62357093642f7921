#pragma once

#include <QByteArray>
#include <QImage>
#include <QString>

#include <optional>

namespace ui
{
/// A picture of a model, or why there is none.
struct Thumbnail
{
    QImage picture;       ///< thumbnailPixels square, transparent around the model; null: see problem
    qint64 vertices = -1; ///< -1: not known
    QString problem;      ///< one sentence
};

inline constexpr int thumbnailPixels = 256;

/// Pictures by the content that they show, as PNG files in a folder. They may vanish at any time, and where none can be
/// written there are none: a cache is no promise. Several programs may use one folder. One thread.
class ThumbnailCache
{
public:
    /// The folder is made when it is first needed. Beyond `capacity` the least recently used are deleted.
    explicit ThumbnailCache(const QString& folder = defaultFolder(), int capacity = 1000);
    static QString defaultFolder();

    /// `key`: names the content; letters and digits.
    std::optional<Thumbnail> find(const QByteArray& key) const;
    void store(const QByteArray& key, const Thumbnail& thumbnail);

private:
    QString pathOf(const QByteArray& key) const;
    void evictOldest();

    QString m_folder;
    int m_capacity;
    int m_count = -1; ///< -1: not counted yet
};
} // namespace ui
