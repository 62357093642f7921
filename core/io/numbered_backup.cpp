#include "core/io/numbered_backup.h"

#include "core/util/atomic_file.h"

#include <string>
#include <system_error>

namespace core
{
namespace
{
namespace fs = std::filesystem;
} // namespace

fs::path NumberedBackup::nameOf(const fs::path& file, int version)
{
    fs::path name = file;
    name += "~" + std::to_string(version);
    return name;
}

NumberedBackup::NumberedBackup(const fs::path& file, int versions) : m_versions(versions)
{
    std::error_code problem;
    m_file = fs::is_symlink(file, problem) ? fs::weakly_canonical(file, problem) : file;
    if (versions < 1 || !fs::is_regular_file(m_file, problem))
        return;
    fs::path waiting = m_file.parent_path() / ".";
    waiting += m_file.filename();
    waiting += "~kept";
    fs::remove(waiting, problem); // left by a program that crashed before commit()
    fs::create_hard_link(m_file, waiting, problem);
    if (problem) { // not every file system has hard links
        problem.clear();
        fs::copy_file(m_file, waiting, problem);
    }
    m_pending = std::move(waiting);
    if (problem) {
        std::error_code ignored;
        fs::remove(m_pending, ignored);
        checkWritten(problem, m_file);
    }
}

NumberedBackup::~NumberedBackup()
{
    std::error_code ignored;
    if (!m_pending.empty())
        fs::remove(m_pending, ignored);
}

void NumberedBackup::commit()
{
    if (m_pending.empty())
        return;
    std::error_code problem;
    for (int version = m_versions - 1; version >= 1; --version) {
        fs::rename(nameOf(m_file, version), nameOf(m_file, version + 1), problem);
        std::error_code ignored;
        if (problem && fs::exists(nameOf(m_file, version), ignored)) // not every version need exist
            checkWritten(problem, nameOf(m_file, version));
    }
    fs::rename(m_pending, nameOf(m_file, 1), problem);
    checkWritten(problem, nameOf(m_file, 1));
    m_pending.clear();
}
} // namespace core
