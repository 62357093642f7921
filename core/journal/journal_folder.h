#pragma once

#include "core/journal/append_file.h"

#include <memory>
#include <vector>

namespace core
{
/// The folder of one document's journal, locked by this process. Other documents and other running programs have
/// folders beside it. When the process ends, even by a crash, the folder is unlocked and counts as abandoned.
class JournalFolder
{
public:
    /// Makes a new folder in `root`, which is created if it does not exist. Throws FileError.
    static std::unique_ptr<JournalFolder> make(const std::filesystem::path& root);
    /// Makes a folder that is hidden until show(): it is located at hiddenPath(), abandoned() ignores it, and the
    /// destructor removes it. Throws FileError.
    static std::unique_ptr<JournalFolder> makeHidden(const std::filesystem::path& root);
    ~JournalFolder();
    JournalFolder(JournalFolder&&) = default;
    /// Returns all visible folders that no process has locked, and locks them. The most recently changed is first.
    /// Removes hidden folders that an ended process left more than an hour ago. Never throws FileError.
    static std::vector<std::unique_ptr<JournalFolder>> abandoned(const std::filesystem::path& root);

    const std::filesystem::path& path() const { return m_path; }
    std::filesystem::path hiddenPath() const;
    /// Renames the hidden folder to path(). Throws FileError. Thread: any.
    void show();
    std::filesystem::file_time_type changed() const; ///< time of the last change
    /// Removes the folder with its content.
    void remove();
    /// Moves the folder to another root, which keeps at most `max` folders: the oldest are removed. Returns the new
    /// path. Returns an empty path if the move fails; the folder is then unchanged.
    std::filesystem::path setAside(const std::filesystem::path& root, std::size_t max);

private:
    JournalFolder(std::filesystem::path path, std::unique_ptr<FolderLock> lock)
        : m_path(std::move(path))
        , m_lock(std::move(lock))
    {}

    std::filesystem::path m_path;
    std::unique_ptr<FolderLock> m_lock;
    bool m_isHidden = false;
};
} // namespace core
