#include "core/journal/append_file.h"

#include "core/util/atomic_file.h"
#include "core/util/file_error.h"
#include "core/util/system_file_windows.h"

#include <io.h>

namespace core
{
namespace
{
[[noreturn]] void fail(const std::filesystem::path& path, DWORD problem)
{
    const int systemError = static_cast<int>(problem);
    throw FileError(kindOfWriteError(systemError), path, systemError);
}

/// Returns the lock of a folder: a hidden file beside it, because Windows renames no folder in which a file is open. A
/// dot at the front of the folder's name does not count, so that the lock stays the same when the folder is hidden or
/// shown (journal_folder.cpp).
std::filesystem::path lockFileOf(const std::filesystem::path& folder)
{
    std::wstring name = folder.filename().native();
    if (name.starts_with('.'))
        name.erase(0, 1);
    return folder.parent_path() / (L"." + name + L".lock");
}

/// Returns whether the lock file exists, perhaps only until its last holder has closed it.
bool isThere(const std::filesystem::path& lockFile)
{
    return GetFileAttributesW(systemPath(lockFile).c_str()) != INVALID_FILE_ATTRIBUTES ||
           GetLastError() != ERROR_FILE_NOT_FOUND;
}
} // namespace

/// FILE_APPEND_DATA without FILE_WRITE_DATA: the system itself puts each write at the end.
AppendFile::AppendFile(const std::filesystem::path& path)
    : m_path(path)
    , m_descriptor(openFile(path, {FILE_APPEND_DATA | SYNCHRONIZE, shareAll, CREATE_NEW}))
{
    if (m_descriptor < 0)
        fail(path, GetLastError());
}

AppendFile::~AppendFile()
{
    closeFile(m_descriptor);
}

void AppendFile::append(std::string_view bytes)
{
    if (const DWORD problem = writeAll(m_descriptor, bytes.data(), bytes.size()))
        fail(m_path, problem);
}

void AppendFile::sync()
{
    if (!FlushFileBuffers(handleOf(m_descriptor)))
        fail(m_path, GetLastError());
}

/// Opens the file for writing, which FlushFileBuffers() requires.
void syncFile(const std::filesystem::path& file)
{
    const int descriptor = openFile(file, {GENERIC_WRITE, shareAll, OPEN_EXISTING});
    if (descriptor < 0)
        fail(file, GetLastError());
    const DWORD problem = FlushFileBuffers(handleOf(descriptor)) ? 0 : GetLastError();
    closeFile(descriptor);
    if (problem != 0)
        fail(file, problem);
}

/// Nobody else can open the file while it is open here. The system deletes it when it is closed, by a crash, too.
FolderLock::FolderLock(const std::filesystem::path& folder) : m_descriptor(-1)
{
    const DWORD attributes = GetFileAttributesW(systemPath(folder).c_str());
    if (attributes == INVALID_FILE_ATTRIBUTES)
        fail(folder, GetLastError());
    if (!(attributes & FILE_ATTRIBUTE_DIRECTORY))
        fail(folder, ERROR_DIRECTORY);
    const std::filesystem::path file = lockFileOf(folder);
    const HANDLE lock = CreateFileW(systemPath(file).c_str(), GENERIC_READ | GENERIC_WRITE | DELETE, 0, nullptr,
                                    OPEN_ALWAYS, FILE_ATTRIBUTE_HIDDEN | FILE_FLAG_DELETE_ON_CLOSE, nullptr);
    const DWORD problem = lock == INVALID_HANDLE_VALUE ? GetLastError() : 0;
    // Access is denied, too, while the system deletes the file.
    const bool isTaken = problem == ERROR_SHARING_VIOLATION || (problem == ERROR_ACCESS_DENIED && isThere(file));
    if (problem != 0 && !isTaken)
        fail(file, problem);
    if (problem != 0)
        return;
    m_descriptor = _open_osfhandle(reinterpret_cast<std::intptr_t>(lock), 0);
    if (m_descriptor < 0) {
        CloseHandle(lock);
        fail(file, ERROR_TOO_MANY_OPEN_FILES);
    }
    m_isHeld = true;
}

FolderLock::~FolderLock()
{
    closeFile(m_descriptor);
}
} // namespace core
