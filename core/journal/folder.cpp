#include "folder.h"

#include "files.h"

#include "../atomic_file.h"

#include <algorithm>
#include <chrono>
#include <random>

namespace core
{
namespace
{
namespace fs = std::filesystem;

/// Folders that come or go have such a name; what is left of them by programs that ended then is of no use.
constexpr char hiddenMark = '.';
constexpr auto oldAge = std::chrono::hours(1);

/// Nobody else's: 64 bits by chance.
std::string newName()
{
    std::random_device random;
    const std::uint64_t chance = (std::uint64_t(random()) << 32) | random();
    return std::to_string(chance);
}

/// Null if somebody else holds it, or it is gone.
std::unique_ptr<FolderLock> lockOf(const fs::path& folder)
{
    try {
        auto lock = std::make_unique<FolderLock>(folder);
        return lock->isHeld() ? std::move(lock) : nullptr;
    } catch (const FileError&) {
        return nullptr;
    }
}

void clear(const fs::path& hidden)
{
    std::error_code problem;
    const auto changed = fs::last_write_time(hidden, problem);
    if (!problem && fs::file_time_type::clock::now() - changed > oldAge && lockOf(hidden))
        fs::remove_all(hidden, problem);
}
} // namespace

std::unique_ptr<JournalFolder> JournalFolder::make(const fs::path& root)
{
    const std::string name = newName();
    const fs::path hidden = root / (hiddenMark + name), path = root / name;
    std::error_code problem;
    const auto check = [&] {
        if (!problem)
            return;
        FileError error(kindOfWriteError(problem.value()), root);
        error.systemError = problem.value();
        throw error;
    };
    fs::create_directories(hidden, problem);
    check();
    fs::permissions(hidden, fs::perms::owner_all, problem);
    check();
    auto lock = std::make_unique<FolderLock>(hidden);
    fs::rename(hidden, path, problem);
    check();
    return std::unique_ptr<JournalFolder>(new JournalFolder(path, std::move(lock)));
}

std::vector<std::unique_ptr<JournalFolder>> JournalFolder::abandoned(const fs::path& root)
{
    std::vector<std::unique_ptr<JournalFolder>> found;
    std::error_code problem;
    for (const auto& entry : fs::directory_iterator(root, problem)) {
        if (entry.path().filename().string().front() == hiddenMark)
            clear(entry.path());
        else if (auto lock = lockOf(entry.path()))
            found.push_back(std::unique_ptr<JournalFolder>(new JournalFolder(entry.path(), std::move(lock))));
    }
    std::ranges::sort(found, std::greater(), &JournalFolder::changed);
    return found;
}

fs::file_time_type JournalFolder::changed() const
{
    std::error_code problem;
    fs::file_time_type latest = fs::last_write_time(startFile(m_path), problem);
    for (const auto& segment : filesIn(m_path).segments)
        latest = std::max(latest, fs::last_write_time(segmentFile(m_path, segment.first), problem));
    return latest;
}

void JournalFolder::remove()
{
    std::error_code ignored;
    const fs::path hidden = m_path.parent_path() / (hiddenMark + m_path.filename().string());
    fs::rename(m_path, hidden, ignored);
    fs::remove_all(hidden, ignored);
}
} // namespace core
