#include "core/journal/journal_folder.h"

#include "core/journal/journal_files.h"

#include "core/util/atomic_file.h"

#include <algorithm>
#include <chrono>
#include <random>

namespace core
{
namespace
{
namespace fs = std::filesystem;

/// First character of the name of a folder that is being made or removed. Such a folder is useless if its program has
/// ended, and is removed when it is older than oldAge.
constexpr char hiddenMark = '.';
constexpr auto oldAge = std::chrono::hours(1);

/// Returns 64 random bits as text: unique among all folders.
std::string newName()
{
    std::random_device random;
    const std::uint64_t chance = (std::uint64_t(random()) << 32) | random();
    return std::to_string(chance);
}

/// Returns the lock; null if another process has it or the folder does not exist.
std::unique_ptr<FolderLock> lockOf(const fs::path& folder)
{
    try {
        auto lock = std::make_unique<FolderLock>(folder);
        return lock->isHeld() ? std::move(lock) : nullptr;
    } catch (const FileError&) {
        return nullptr;
    }
}

fs::path hiddenOf(const fs::path& folder)
{
    return folder.parent_path() / (hiddenMark + folder.filename().string());
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
    auto folder = makeHidden(root);
    folder->show();
    return folder;
}

std::unique_ptr<JournalFolder> JournalFolder::makeHidden(const fs::path& root)
{
    const fs::path path = root / newName(), hidden = hiddenOf(path);
    std::error_code problem;
    fs::create_directories(hidden, problem);
    checkWritten(problem, root);
    fs::permissions(hidden, fs::perms::owner_all, problem);
    checkWritten(problem, root);
    auto lock = std::make_unique<FolderLock>(hidden);
    std::unique_ptr<JournalFolder> folder(new JournalFolder(path, std::move(lock)));
    folder->m_isHidden = true;
    return folder;
}

JournalFolder::~JournalFolder()
{
    if (m_lock && m_isHidden)
        remove();
}

fs::path JournalFolder::hiddenPath() const
{
    return hiddenOf(m_path);
}

void JournalFolder::show()
{
    std::error_code problem;
    fs::rename(hiddenPath(), m_path, problem);
    if (problem && !renameFolder(hiddenPath(), m_path)) // on Windows this waits for virus scanners
        checkWritten(problem, m_path);
    m_isHidden = false;
}

std::vector<std::unique_ptr<JournalFolder>> JournalFolder::abandoned(const fs::path& root)
{
    std::vector<std::unique_ptr<JournalFolder>> found;
    std::error_code problem;
    for (const auto& entry : fs::directory_iterator(root, problem)) {
        if (entry.path().filename().native().front() == hiddenMark)
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
    fs::rename(m_path, hiddenPath(), ignored);
    fs::remove_all(hiddenPath(), ignored);
    fs::remove_all(m_path, ignored); // Windows renames no folder while a virus scanner has a file of it open
}

fs::path JournalFolder::setAside(const fs::path& root, std::size_t max)
{
    std::error_code problem;
    fs::create_directories(root, problem);
    const fs::path path = root / m_path.filename();
    try {
        if (problem || !renameFolder(m_path, path))
            return {};
    } catch (const FileError&) {
        return {};
    }
    m_path = path;
    fs::last_write_time(path, fs::file_time_type::clock::now(), problem);
    std::vector<std::pair<fs::file_time_type, fs::path>> kept;
    for (const auto& entry : fs::directory_iterator(root, problem))
        kept.emplace_back(entry.last_write_time(problem), entry.path());
    std::ranges::sort(kept, std::greater());
    for (std::size_t i = max; i < kept.size(); ++i)
        fs::remove_all(kept[i].second, problem);
    return path;
}
} // namespace core
