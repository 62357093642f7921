#pragma once

#include <QHash>
#include <QString>

namespace ui
{
/// A file or folder with its state on disk at the time of listing. Entries with the same path, size and date are
/// equal; the content is then usually the same, but it is not compared.
struct FileEntry
{
    QString path; ///< absolute
    bool isFolder = false;
    qint64 size = 0;       ///< bytes; meaningless for a folder
    qint64 modifiedMs = 0; ///< ms since 1970, UTC

    bool operator==(const FileEntry&) const = default;
};

inline size_t qHash(const FileEntry& entry, size_t seed = 0)
{
    return qHashMulti(seed, entry.path, entry.size, entry.modifiedMs);
}
} // namespace ui
