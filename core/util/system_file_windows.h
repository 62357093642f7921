#pragma once

#include "core/util/system_path.h"

#include <windows.h>

namespace core
{
// The headers of MinGW 10 lack these.
constexpr DWORD errorDiskQuotaExceeded = 1295;                                ///< ERROR_DISK_QUOTA_EXCEEDED
constexpr DWORD errorDirectoryNotSupported = 336;                             ///< ERROR_DIRECTORY_NOT_SUPPORTED
constexpr auto fileRenameInfoEx = static_cast<FILE_INFO_BY_HANDLE_CLASS>(22); ///< FileRenameInfoEx, Windows 10 1607

/// Closes a handle at the end of its scope.
class ScopedHandle
{
public:
    explicit ScopedHandle(HANDLE handle = nullptr) : m_handle(handle) {}
    ~ScopedHandle() { reset(); }
    ScopedHandle(const ScopedHandle&) = delete;
    ScopedHandle& operator=(const ScopedHandle&) = delete;

    HANDLE get() const { return m_handle; }
    /// Returns where a system call stores a new handle. Precondition: none is held.
    HANDLE* out() { return &m_handle; }
    explicit operator bool() const { return m_handle && m_handle != INVALID_HANDLE_VALUE; }
    void reset(HANDLE handle = nullptr);

private:
    HANDLE m_handle;
};

/// How openFile() opens a file.
struct FileAccess
{
    DWORD access;      ///< GENERIC_READ, GENERIC_WRITE, DELETE, ...
    DWORD share;       ///< what others may do meanwhile: FILE_SHARE_READ, ...
    DWORD disposition; ///< OPEN_EXISTING, CREATE_NEW, ...
};
/// Share mode of open files: other programs may read, write and delete them, as on other systems.
constexpr DWORD shareAll = FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE;

/// Opens a file and returns a descriptor of the C library, which children do not inherit. Returns -1 if that fails;
/// GetLastError() then has the reason. A file that another program has just closed, but that a virus scanner still
/// holds, is tried again for up to half a second.
int openFile(const std::filesystem::path& path, const FileAccess& access);

/// Closes a descriptor; -1 is none.
void closeFile(int descriptor);

/// Returns the system's handle of a descriptor.
HANDLE handleOf(int descriptor);

/// Writes all bytes where the file ends or, for a file that was not opened to append, at its position. Returns 0, or
/// the system code of the failure.
DWORD writeAll(int descriptor, const char* bytes, std::size_t size);

/// Repeats a step for up to half a second as long as it fails because another program has the file open, as virus
/// scanners and the index of the desktop's search do for a moment. Returns 0, or the system code of the failure. `step`
/// returns whether it succeeded and leaves the reason in GetLastError(). `inUseToo`: another code that may mean this.
template <typename Step> DWORD retryWhileInUse(const Step& step, DWORD inUseToo = ERROR_SHARING_VIOLATION)
{
    constexpr int maxTries = 10;
    constexpr DWORD pauseMs = 50;
    for (int i = 1;; ++i) {
        if (step())
            return 0;
        const DWORD problem = GetLastError();
        const bool isInUse =
            problem == ERROR_SHARING_VIOLATION || problem == ERROR_LOCK_VIOLATION || problem == inUseToo;
        if (!isInUse || i == maxTries)
            return problem;
        Sleep(pauseMs);
    }
}
} // namespace core
