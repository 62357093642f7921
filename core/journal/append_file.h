#pragma once

#include <filesystem>
#include <string_view>

namespace core
{
/// A file that only grows. What append() took outlives the process, what sync() saw outlives a power cut. Each member
/// throws FileError; append() and sync() may run at once on two threads.
class AppendFile
{
public:
    /// A new one: it must not exist.
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

/// The file's content outlives a power cut. Throws FileError.
void syncFile(const std::filesystem::path& file);

/// A folder that belongs to a process while that lives, however it ends.
class FolderLock
{
public:
    /// Of a folder that exists. Does not wait: isHeld() says whether it is ours now. Throws FileError if it cannot be
    /// tried.
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
