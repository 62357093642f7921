#include "core/util/system_code.h"

#include "core/util/system_file_windows.h"

#include <cerrno>
#include <cstdlib>
#include <utility>

namespace core
{
namespace
{
/// The meaning of system codes. The first row of a meaning is the code for it.
constexpr std::pair<DWORD, int> meanings[] = {
    {ERROR_FILE_NOT_FOUND, ENOENT},
    {ERROR_PATH_NOT_FOUND, ENOENT},
    {ERROR_BAD_NETPATH, ENOENT},
    {ERROR_BAD_NET_NAME, ENOENT},
    {ERROR_INVALID_DRIVE, ENOENT},
    {ERROR_ACCESS_DENIED, EACCES},
    {ERROR_SHARING_VIOLATION, EACCES},
    {ERROR_LOCK_VIOLATION, EACCES},
    {ERROR_ACCESS_DENIED, EPERM},
    {ERROR_PRIVILEGE_NOT_HELD, EPERM},
    {ERROR_WRITE_PROTECT, EROFS},
    {ERROR_FILE_EXISTS, EEXIST},
    {ERROR_ALREADY_EXISTS, EEXIST},
    {ERROR_DIR_NOT_EMPTY, ENOTEMPTY},
    {ERROR_DIRECTORY, ENOTDIR},
    {errorDirectoryNotSupported, EISDIR},
    {ERROR_DISK_FULL, ENOSPC},
    {ERROR_HANDLE_DISK_FULL, ENOSPC},
    {errorDiskQuotaExceeded, ENOSPC},
    {ERROR_NOT_ENOUGH_MEMORY, ENOMEM},
    {ERROR_OUTOFMEMORY, ENOMEM},
    {ERROR_TOO_MANY_OPEN_FILES, EMFILE},
    {ERROR_INVALID_PARAMETER, EINVAL},
    {ERROR_INVALID_NAME, EINVAL},
    {ERROR_FILENAME_EXCED_RANGE, ENAMETOOLONG},
    {ERROR_BROKEN_PIPE, EPIPE},
    {ERROR_NO_DATA, EPIPE},
    {ERROR_NOT_SAME_DEVICE, EXDEV},
    {ERROR_CANT_RESOLVE_FILENAME, ELOOP},
    {ERROR_NOT_SUPPORTED, ENOSYS},
    {ERROR_BUSY, EBUSY},
    {ERROR_IO_DEVICE, EIO},
};
} // namespace

/// The C++ library gives some failures as errno.
int systemCodeOf(const std::error_code& problem)
{
    if (problem.category() != std::generic_category() || !problem)
        return problem.value();
    for (const auto& [code, meaning] : meanings)
        if (meaning == problem.value())
            return static_cast<int>(code);
    return ERROR_GEN_FAILURE;
}

bool isSystemCode(int systemCode, std::errc meaning)
{
    for (const auto& [code, known] : meanings)
        if (static_cast<int>(code) == systemCode && known == static_cast<int>(meaning))
            return true;
    return false;
}

void clearStreamCode()
{
    _doserrno = 0;
}

/// The C library keeps the code itself: GetLastError() may be changed by what runs after the failure.
int streamCode()
{
    return static_cast<int>(_doserrno);
}
} // namespace core
