#include "core/util/system_file_windows.h"

#include <fcntl.h>
#include <io.h>

#include <algorithm>

namespace core
{
void ScopedHandle::reset(HANDLE handle)
{
    if (*this)
        CloseHandle(m_handle);
    m_handle = handle;
}

int openFile(const std::filesystem::path& path, const FileAccess& access)
{
    const std::filesystem::path name = systemPath(path);
    HANDLE handle = INVALID_HANDLE_VALUE;
    const DWORD problem = retryWhileInUse([&] {
        // Without security attributes, so that children do not inherit the file.
        handle = CreateFileW(name.c_str(), access.access, access.share, nullptr, access.disposition,
                             FILE_ATTRIBUTE_NORMAL, nullptr);
        return handle != INVALID_HANDLE_VALUE;
    });
    if (problem != 0) {
        SetLastError(problem);
        return -1;
    }
    const int descriptor = _open_osfhandle(reinterpret_cast<std::intptr_t>(handle), _O_BINARY | _O_NOINHERIT);
    if (descriptor < 0) {
        CloseHandle(handle);
        SetLastError(ERROR_TOO_MANY_OPEN_FILES);
    }
    return descriptor;
}

void closeFile(int descriptor)
{
    if (descriptor >= 0) // the C library takes any other for a fault of the program
        _close(descriptor);
}

HANDLE handleOf(int descriptor)
{
    return reinterpret_cast<HANDLE>(_get_osfhandle(descriptor));
}

DWORD writeAll(int descriptor, const char* bytes, std::size_t size)
{
    constexpr std::size_t atOnce = std::size_t(1) << 26; // some network drives refuse more
    while (size != 0) {
        DWORD written = 0;
        if (!WriteFile(handleOf(descriptor), bytes, static_cast<DWORD>(std::min(size, atOnce)), &written, nullptr))
            return GetLastError();
        if (written == 0)
            return ERROR_WRITE_FAULT;
        bytes += written;
        size -= written;
    }
    return 0;
}
} // namespace core
