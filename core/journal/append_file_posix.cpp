#include "core/journal/append_file.h"

#include "core/util/atomic_file.h"
#include "core/util/file_error.h"

#include <cerrno>
#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

namespace core
{
namespace
{
[[noreturn]] void fail(const std::filesystem::path& path)
{
    const int systemError = errno;
    throw FileError(kindOfWriteError(systemError), path, systemError);
}
} // namespace

AppendFile::AppendFile(const std::filesystem::path& path)
    : m_path(path)
    , m_descriptor(::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_APPEND | O_CLOEXEC, 0600))
{
    if (m_descriptor < 0)
        fail(path);
}

AppendFile::~AppendFile()
{
    ::close(m_descriptor);
}

void AppendFile::append(std::string_view bytes)
{
    while (!bytes.empty()) {
        const ssize_t written = ::write(m_descriptor, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR)
            continue;
        if (written <= 0)
            fail(m_path);
        bytes.remove_prefix(static_cast<std::size_t>(written));
    }
}

void AppendFile::sync()
{
    if (::fdatasync(m_descriptor) != 0)
        fail(m_path);
}

void syncFile(const std::filesystem::path& file)
{
    const int descriptor = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
    if (descriptor < 0)
        fail(file);
    const bool isSynced = ::fsync(descriptor) == 0;
    const int systemError = errno;
    ::close(descriptor);
    errno = systemError;
    if (!isSynced)
        fail(file);
}

FolderLock::FolderLock(const std::filesystem::path& folder)
    : m_descriptor(::open((folder / "lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600))
{
    if (m_descriptor < 0)
        fail(folder / "lock");
    m_isHeld = ::flock(m_descriptor, LOCK_EX | LOCK_NB) == 0;
}

FolderLock::~FolderLock()
{
    ::close(m_descriptor);
}
} // namespace core
