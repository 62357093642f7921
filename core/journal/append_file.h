#pragma once

#include <filesystem>
#include <string_view>

namespace core
{
/// A file that is only appended to. Appended bytes survive the end of the process; synced bytes survive a power cut.
/// The constructor, append() and sync() throw FileError. Thread: append() and sync() may run concurrently.
class AppendFile
{
public:
    /// Creates the file. Precondition: it does not exist.
    explicit AppendFile(const std::filesystem::path& path);
    ~AppendFile();
    AppendFile(const AppendFile&) = delete;
    AppendFile& operator=(const AppendFile&) = delete;

    void append(std::string_view bytes);
    void sync();

private:
    std::filesystem::path m_path;
    int m_descriptor;
};

/// Makes the file's content survive a power cut. Throws FileError.
void syncFile(const std::filesystem::path& file);

/// An exclusive lock on a folder. The system releases it when the process ends, even by a crash.
class FolderLock
{
public:
    /// Tries to lock an existing folder without waiting; isHeld() returns whether it succeeded. Throws FileError if the
    /// lock file cannot be opened.
    explicit FolderLock(const std::filesystem::path& folder);
    ~FolderLock();
    FolderLock(const FolderLock&) = delete;
    FolderLock& operator=(const FolderLock&) = delete;

    bool isHeld() const { return m_isHeld; }

private:
    int m_descriptor;
    bool m_isHeld = false;
};
} // namespace core
