#pragma once

#include <filesystem>

namespace core
{
/// Keeps earlier versions of a file beside it: "vase.glb~1" is the content before the last write, "vase.glb~2" the one
/// before that, and so on. The backups change only in commit(); if it is never called, even after a crash, they stay
/// unchanged.
class NumberedBackup
{
public:
    /// Saves the content of a file that AtomicFile is about to replace. A missing file is ignored. `versions`: number
    /// of backups to keep; 0: none. Throws FileError.
    NumberedBackup(const std::filesystem::path& file, int versions);
    ~NumberedBackup();
    NumberedBackup(const NumberedBackup&) = delete;
    NumberedBackup& operator=(const NumberedBackup&) = delete;

    /// Renumbers the backups and deletes the oldest. Precondition: the new file has been written. Throws FileError.
    void commit();

    static std::filesystem::path nameOf(const std::filesystem::path& file, int version); ///< 1: the latest

private:
    std::filesystem::path m_file;
    std::filesystem::path m_pending; ///< hidden copy or link of the old content; empty: nothing to keep
    int m_versions;
};
} // namespace core
