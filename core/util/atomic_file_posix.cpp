#include "core/util/atomic_file.h"

#include "core/util/system_path.h"

#include <cerrno>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace core
{
namespace
{
unsigned long ownProcess()
{
    return static_cast<unsigned long>(::getpid());
}

/// Returns the path at which a chain of symbolic links ends. The path need not exist.
std::filesystem::path endOfLinks(std::filesystem::path path, std::error_code& error)
{
    constexpr int longest = 40; // limit of the system on a chain of links
    for (int i = 0; std::filesystem::is_symlink(path, error); ++i) {
        const std::filesystem::path next = std::filesystem::read_symlink(path, error);
        if (i == longest)
            error = std::make_error_code(std::errc::too_many_symbolic_link_levels);
        if (error)
            return path;
        path = next.is_absolute() ? next : path.parent_path() / next;
    }
    error.clear(); // a missing file is no error: it will be created
    return path;
}
} // namespace

void syncFolder(const std::filesystem::path& folder)
{
    const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor < 0)
        return;
    ::fsync(descriptor);
    ::close(descriptor);
}

FileErrorKind kindOfWriteError(int systemError)
{
    switch (systemError) {
    case ENOSPC:
    case EDQUOT:
        return FileErrorKind::DiskFull;
    case EACCES:
    case EPERM:
    case EROFS:
        return FileErrorKind::NotWritable;
    case ENOENT:
    case ENOTDIR:
        return FileErrorKind::NoFolder;
    case EISDIR:
        return FileErrorKind::NotAFile;
    default:
        return FileErrorKind::WriteFailed;
    }
}

/// An empty folder that already has the new name is replaced: no data is lost.
bool renameFolder(const std::filesystem::path& from, const std::filesystem::path& to)
{
    if (::rename(from.c_str(), to.c_str()) == 0) {
        syncFolder(parentFolder(to));
        return true;
    }
    const int problem = errno;
    if (problem == EEXIST || problem == ENOTEMPTY || problem == ENOTDIR)
        return false;
    checkWritten(std::error_code(problem, std::generic_category()), to);
    return false;
}

AtomicFile::AtomicFile(const std::filesystem::path& path) : m_path(path), m_target(path)
{
    std::error_code error;
    m_target = endOfLinks(path, error);
    if (error)
        fail(error.value());
    struct stat status = {};
    const bool exists = ::stat(m_target.c_str(), &status) == 0;
    if (exists && !S_ISREG(status.st_mode))
        throw FileError(FileErrorKind::NotAFile, m_path);
    if (exists && ::access(m_target.c_str(), W_OK) != 0)
        fail(errno);
    openTemporary();
    if (exists)
        static_cast<void>(
            ::fchmod(m_descriptor, status.st_mode & 07777)); // best effort: some file systems have no modes
    m_buffer.reserve(bufferSize);
}

/// Opens the temporary file, without a name where O_TMPFILE is supported: then even a killed program leaves nothing
/// behind.
void AtomicFile::openTemporary()
{
#ifdef O_TMPFILE
    m_descriptor = ::open(parentFolder(m_target).c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, 0666);
    if (m_descriptor >= 0)
        return;
#endif
    m_temporary = temporaryName(ownProcess());
    m_descriptor = ::open(m_temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (m_descriptor < 0) {
        const int error = errno;
        m_temporary.clear();
        fail(error);
    }
}

AtomicFile::~AtomicFile()
{
    if (m_descriptor >= 0)
        ::close(m_descriptor);
    if (!m_temporary.empty())
        ::unlink(m_temporary.c_str());
}

void AtomicFile::writeNow(std::string_view bytes)
{
    std::size_t done = 0;
    while (done < bytes.size()) {
        const ssize_t written = ::write(m_descriptor, bytes.data() + done, bytes.size() - done);
        if (written < 0 && errno == EINTR)
            continue;
        if (written <= 0)
            fail(written < 0 ? errno : EIO);
        done += static_cast<std::size_t>(written);
    }
}

void AtomicFile::sync()
{
    flush();
    if (::fdatasync(m_descriptor) != 0)
        fail(errno);
}

void AtomicFile::giveTemporaryName()
{
    const std::string self = "/proc/self/fd/" + std::to_string(m_descriptor);
    std::filesystem::path name = temporaryName(ownProcess());
    if (::linkat(AT_FDCWD, self.c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW) != 0)
        fail(errno);
    m_temporary = std::move(name);
}

void AtomicFile::commit()
{
    flush();
    if (::fsync(m_descriptor) != 0)
        fail(errno);
    if (m_temporary.empty())
        giveTemporaryName();
    const int descriptor = m_descriptor;
    m_descriptor = -1;
    if (::close(descriptor) != 0) // some network file systems report a full disk only here
        fail(errno);
    if (::rename(m_temporary.c_str(), m_target.c_str()) != 0)
        fail(errno);
    m_temporary.clear();
    syncFolder(parentFolder(m_target));
}
} // namespace core
