#pragma once

#include <QByteArray>
#include <QImage>
#include <QString>

#include <optional>

namespace ui
{
/// The picture of a model, or the reason why there is none.
struct Thumbnail
{
    QImage picture;       ///< thumbnailPixels wide and high, transparent around the model; null: see problem
    qint64 vertices = -1; ///< -1: unknown
    QString problem;      ///< why there is no picture, one sentence; empty: there is one
};

inline constexpr int thumbnailPixels = 256;

/// A cache of pictures in a folder, as PNG files named by the content of the model file. Errors are ignored: pictures
/// may vanish at any time, or never be stored. Several programs may share the folder. Thread: one at a time.
class ThumbnailCache
{
public:
    /// The folder is created at first use. Beyond `capacity` pictures the least recently used ones are deleted.
    explicit ThumbnailCache(const QString& folder = defaultFolder(), int capacity = 1000);
    static QString defaultFolder();

    /// `key`: identifies the content; consists of letters and digits.
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
