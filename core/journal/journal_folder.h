#pragma once

#include "core/journal/append_file.h"

#include <memory>
#include <vector>

namespace core
{
/// A folder for one document's journal, among those of other documents and programs that run: nobody else has it while
/// it is held, and it is without an owner once the process has ended, however it did.
class JournalFolder
{
public:
    /// A new one under `root`, which is made if need be. Throws FileError.
    static std::unique_ptr<JournalFolder> make(const std::filesystem::path& root);
    /// The same, but until show() it is at hiddenPath(), is never found as abandoned(), and is gone with the object.
    static std::unique_ptr<JournalFolder> makeHidden(const std::filesystem::path& root);
    ~JournalFolder();
    JournalFolder(JournalFolder&&) = default;
    /// Those that nobody holds, which are held from now on; the latest change comes first. Never throws FileError.
    static std::vector<std::unique_ptr<JournalFolder>> abandoned(const std::filesystem::path& root);

    const std::filesystem::path& path() const { return m_path; }
    std::filesystem::path hiddenPath() const;
    /// Any thread. Throws FileError.
    void show();
    std::filesystem::file_time_type changed() const; ///< the last time
    /// With all that is in it.
    void remove();
    /// It goes to another root, where so many stay: the oldest go. Its new path; empty if that is impossible, and it
    /// stays where it is.
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
