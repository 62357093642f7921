#pragma once

#include "append_file.h"

#include <memory>
#include <vector>

namespace core
{
/// A folder for one document's journal, among those of other documents and programs that run: nobody else has it while it is held, and
/// it is without an owner once the process has ended, however it did.
class JournalFolder
{
public:
    /// A new one under `root`, which is made if need be. Throws FileError.
    static std::unique_ptr<JournalFolder> make(const std::filesystem::path& root);
    /// Those that nobody holds, which are held from now on; the latest change comes first. Never throws FileError.
    static std::vector<std::unique_ptr<JournalFolder>> abandoned(const std::filesystem::path& root);

    const std::filesystem::path& path() const { return m_path; }
    std::filesystem::file_time_type changed() const; ///< the last time
    /// With all that is in it.
    void remove();

private:
    JournalFolder(std::filesystem::path path, std::unique_ptr<FolderLock> lock) : m_path(std::move(path)), m_lock(std::move(lock)) {}

    std::filesystem::path m_path;
    std::unique_ptr<FolderLock> m_lock;
};
} // namespace core
