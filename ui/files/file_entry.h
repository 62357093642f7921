#pragma once

#include <QHash>
#include <QString>

namespace ui
{
/// A file or folder as the disk had it when it was asked. Equal ones have the same content, as far as can be told
/// without reading it.
struct FileEntry
{
    QString path; ///< absolute
    bool isFolder = false;
    qint64 size = 0;       ///< bytes; a folder's means nothing
    qint64 modifiedMs = 0; ///< since 1970, UTC

    bool operator==(const FileEntry&) const = default;
};

inline size_t qHash(const FileEntry& entry, size_t seed = 0)
{
    return qHashMulti(seed, entry.path, entry.size, entry.modifiedMs);
}
} // namespace ui
