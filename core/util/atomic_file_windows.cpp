// Sources: Microsoft Learn, "SetFileInformationByHandle function", FILE_RENAME_INFO, FILE_DISPOSITION_INFO;
// [MS-FSCC] 2.1.2.4 (symbolic links).
#include "core/util/atomic_file.h"

#include "core/util/system_file_windows.h"

#include <array>
#include <cstddef>
#include <cstring>
#include <vector>
#include <winioctl.h>

namespace core
{
namespace
{
/// The beginning of what the system tells about a symbolic link; the names follow.
struct LinkHeader
{
    ULONG tag;
    USHORT size, reserved;
    USHORT targetOffset, targetSize, shownOffset, shownSize; ///< bytes, from the end of this header
    ULONG flags;
};

/// Returns where a symbolic link leads, as it is written there; empty: the path is no symbolic link.
std::filesystem::path linkTarget(const std::filesystem::path& path)
{
    const std::filesystem::path name = systemPath(path);
    const DWORD attributes = GetFileAttributesW(name.c_str());
    if (attributes == INVALID_FILE_ATTRIBUTES || !(attributes & FILE_ATTRIBUTE_REPARSE_POINT))
        return {};
    const ScopedHandle link(CreateFileW(name.c_str(), 0, shareAll, nullptr, OPEN_EXISTING,
                                        FILE_FLAG_OPEN_REPARSE_POINT | FILE_FLAG_BACKUP_SEMANTICS, nullptr));
    std::array<std::byte, MAXIMUM_REPARSE_DATA_BUFFER_SIZE> bytes;
    DWORD got = 0;
    LinkHeader header{};
    if (!link ||
        !DeviceIoControl(link.get(), FSCTL_GET_REPARSE_POINT, nullptr, 0, bytes.data(), bytes.size(), &got, nullptr) ||
        got < sizeof header)
        return {};
    std::memcpy(&header, bytes.data(), sizeof header);
    if (header.tag != IO_REPARSE_TAG_SYMLINK || sizeof header + header.targetOffset + header.targetSize > got)
        return {};
    std::wstring target(header.targetSize / sizeof(wchar_t), '\0');
    std::memcpy(target.data(), bytes.data() + sizeof header + header.targetOffset, header.targetSize);
    constexpr std::wstring_view kernelPrefix = LR"(\??\)", longPrefix = LR"(\\?\)";
    if (target.starts_with(kernelPrefix))
        target.replace(0, kernelPrefix.size(), longPrefix);
    return target;
}

/// Returns the path at which a chain of symbolic links ends. The path need not exist. `problem`: set if there is no
/// end.
std::filesystem::path endOfLinks(std::filesystem::path path, DWORD& problem)
{
    constexpr int longest = 63; // limit of the system on a chain of links
    for (int i = 0; i <= longest; ++i) {
        const std::filesystem::path next = linkTarget(path);
        if (next.empty())
            return path;
        path = path.parent_path() / next; // `next` alone if it is absolute
    }
    problem = ERROR_CANT_RESOLVE_FILENAME;
    return path;
}

bool isFolder(const std::filesystem::path& path)
{
    const DWORD attributes = GetFileAttributesW(systemPath(path).c_str());
    return attributes != INVALID_FILE_ATTRIBUTES && (attributes & FILE_ATTRIBUTE_DIRECTORY);
}

/// Says whether the system deletes the file as soon as its last handle is closed, even by a crash. Only a hint: some
/// network drives refuse. Precondition: the file was opened with the right DELETE.
void deleteWhenClosed(int descriptor, bool isWanted)
{
    FILE_DISPOSITION_INFO info{static_cast<BOOLEAN>(isWanted)};
    SetFileInformationByHandle(handleOf(descriptor), FileDispositionInfo, &info, sizeof info);
}

/// Gives the new file the access rights and the attributes hidden and system of the old one. Only a hint: some file
/// systems have no rights.
void copyPermissions(HANDLE from, int to)
{
    FILE_BASIC_INFO old{}, now{};
    constexpr DWORD kept = FILE_ATTRIBUTE_HIDDEN | FILE_ATTRIBUTE_SYSTEM;
    if (GetFileInformationByHandleEx(from, FileBasicInfo, &old, sizeof old) && (old.FileAttributes & kept)) {
        now.FileAttributes = FILE_ATTRIBUTE_ARCHIVE | (old.FileAttributes & kept);
        SetFileInformationByHandle(handleOf(to), FileBasicInfo, &now, sizeof now);
    }
    DWORD size = 0;
    GetKernelObjectSecurity(from, DACL_SECURITY_INFORMATION, nullptr, 0, &size);
    std::vector<std::byte> rights(size);
    SECURITY_DESCRIPTOR_CONTROL control = 0;
    DWORD revision = 0;
    if (size == 0 || !GetKernelObjectSecurity(from, DACL_SECURITY_INFORMATION, rights.data(), size, &size) ||
        !GetSecurityDescriptorControl(rights.data(), &control, &revision))
        return;
    const ScopedHandle writable(ReOpenFile(handleOf(to), WRITE_DAC, shareAll, 0));
    const SECURITY_INFORMATION inheritance =
        control & SE_DACL_PROTECTED ? PROTECTED_DACL_SECURITY_INFORMATION : UNPROTECTED_DACL_SECURITY_INFORMATION;
    if (writable)
        SetKernelObjectSecurity(writable.get(), DACL_SECURITY_INFORMATION | inheritance, rights.data());
}

/// Renames an open file over the target, which programs may be reading: they keep the old content. Returns whether the
/// file system can do this; FAT and some network drives cannot.
bool renameOpenFile(int descriptor, const std::wstring& target)
{
    const std::size_t bytes = target.size() * sizeof(wchar_t);
    std::vector<std::byte> memory(sizeof(FILE_RENAME_INFO) + bytes);
    auto* const info = new (memory.data()) FILE_RENAME_INFO{};
    // The first member is ReplaceIfExists for older systems, and flags here.
    constexpr DWORD flags = 0x1 | 0x2; // FILE_RENAME_FLAG_REPLACE_IF_EXISTS, FILE_RENAME_FLAG_POSIX_SEMANTICS
    std::memcpy(info, &flags, sizeof flags);
    info->FileNameLength = static_cast<DWORD>(bytes);
    std::memcpy(info->FileName, target.data(), bytes);
    return SetFileInformationByHandle(handleOf(descriptor), fileRenameInfoEx, info, static_cast<DWORD>(memory.size()));
}
} // namespace

void syncFolder(const std::filesystem::path& folder)
{
    const ScopedHandle handle(CreateFileW(systemPath(folder).c_str(), GENERIC_WRITE, shareAll, nullptr, OPEN_EXISTING,
                                          FILE_FLAG_BACKUP_SEMANTICS, nullptr));
    if (handle)
        FlushFileBuffers(handle.get());
}

FileErrorKind kindOfWriteError(int systemError)
{
    switch (systemError) {
    case ERROR_DISK_FULL:
    case ERROR_HANDLE_DISK_FULL:
    case errorDiskQuotaExceeded:
        return FileErrorKind::DiskFull;
    case ERROR_ACCESS_DENIED:
    case ERROR_NETWORK_ACCESS_DENIED:
    case ERROR_PRIVILEGE_NOT_HELD:
    case ERROR_WRITE_PROTECT:
    case ERROR_SHARING_VIOLATION:
    case ERROR_LOCK_VIOLATION:
    case ERROR_USER_MAPPED_FILE:
        return FileErrorKind::NotWritable;
    case ERROR_FILE_NOT_FOUND:
    case ERROR_PATH_NOT_FOUND:
    case ERROR_INVALID_DRIVE:
    case ERROR_BAD_NETPATH:
    case ERROR_BAD_NET_NAME:
    case ERROR_DIRECTORY:
    case ERROR_NOT_READY:
        return FileErrorKind::NoFolder;
    case errorDirectoryNotSupported:
        return FileErrorKind::NotAFile;
    default:
        return FileErrorKind::WriteFailed;
    }
}

/// Access is denied while another program has a file of the folder open.
bool renameFolder(const std::filesystem::path& from, const std::filesystem::path& to)
{
    const std::filesystem::path oldName = systemPath(from), newName = systemPath(to);
    const DWORD problem = retryWhileInUse(
        [&] { return MoveFileExW(oldName.c_str(), newName.c_str(), MOVEFILE_WRITE_THROUGH); }, ERROR_ACCESS_DENIED);
    if (problem == 0) {
        syncFolder(parentFolder(to));
        return true;
    }
    if (GetFileAttributesW(newName.c_str()) != INVALID_FILE_ATTRIBUTES)
        return false;
    checkWritten(std::error_code(static_cast<int>(problem), std::system_category()), to);
    return false;
}

AtomicFile::AtomicFile(const std::filesystem::path& path) : m_path(path), m_target(path)
{
    DWORD problem = 0;
    m_target = endOfLinks(path, problem);
    if (problem != 0)
        fail(static_cast<int>(problem));
    if (isFolder(m_target))
        throw FileError(FileErrorKind::NotAFile, m_path);
    // Opened for writing, because only that shows whether the user may. Nothing is written.
    const int existing = openFile(m_target, {GENERIC_WRITE | READ_CONTROL, shareAll, OPEN_EXISTING});
    problem = existing < 0 ? GetLastError() : 0;
    const bool isDevice = existing >= 0 && GetFileType(handleOf(existing)) != FILE_TYPE_DISK;
    try {
        if (isDevice) // such as NUL and COM1, which are in every folder
            throw FileError(FileErrorKind::NotAFile, m_path);
        if (problem != 0 && problem != ERROR_FILE_NOT_FOUND)
            fail(static_cast<int>(problem));
        openTemporary();
        if (existing >= 0)
            copyPermissions(handleOf(existing), m_descriptor);
    } catch (...) {
        closeFile(existing);
        throw;
    }
    closeFile(existing);
    deleteWhenClosed(m_descriptor, true);
    m_buffer.reserve(bufferSize);
}

void AtomicFile::openTemporary()
{
    m_temporary = temporaryName(GetCurrentProcessId());
    m_descriptor =
        openFile(m_temporary, {GENERIC_READ | GENERIC_WRITE | DELETE, FILE_SHARE_READ | FILE_SHARE_DELETE, CREATE_NEW});
    if (m_descriptor < 0) {
        const DWORD problem = GetLastError();
        m_temporary.clear();
        fail(static_cast<int>(problem));
    }
}

AtomicFile::~AtomicFile()
{
    closeFile(m_descriptor);
    if (!m_temporary.empty())
        DeleteFileW(systemPath(m_temporary).c_str());
}

void AtomicFile::writeNow(std::string_view bytes)
{
    if (const DWORD problem = writeAll(m_descriptor, bytes.data(), bytes.size()))
        fail(static_cast<int>(problem));
}

void AtomicFile::sync()
{
    flush();
    if (!FlushFileBuffers(handleOf(m_descriptor)))
        fail(static_cast<int>(GetLastError()));
}

/// Makes the temporary file one that stays when it is closed. Otherwise it would be deleted under the target's name.
void AtomicFile::giveTemporaryName()
{
    deleteWhenClosed(m_descriptor, false);
    FILE_STANDARD_INFO info{};
    if (GetFileInformationByHandleEx(handleOf(m_descriptor), FileStandardInfo, &info, sizeof info) &&
        info.DeletePending)
        fail(ERROR_DELETE_PENDING);
}

void AtomicFile::commit()
{
    sync();
    giveTemporaryName();
    const std::filesystem::path target = systemPath(std::filesystem::absolute(m_target));
    const bool isRenamed = renameOpenFile(m_descriptor, target.native());
    if (isRenamed) {
        m_temporary.clear();
        FlushFileBuffers(handleOf(m_descriptor)); // brings the new name to the disk, too
    }
    closeFile(m_descriptor);
    m_descriptor = -1;
    if (!isRenamed) {
        const std::filesystem::path temporary = systemPath(m_temporary);
        constexpr DWORD how = MOVEFILE_REPLACE_EXISTING | MOVEFILE_WRITE_THROUGH;
        const DWORD problem =
            retryWhileInUse([&] { return MoveFileExW(temporary.c_str(), target.c_str(), how); }, ERROR_ACCESS_DENIED);
        // The constructor was allowed to write to the target: who is denied access now has it open elsewhere.
        if (problem != 0)
            fail(problem == ERROR_ACCESS_DENIED ? ERROR_SHARING_VIOLATION : static_cast<int>(problem));
        m_temporary.clear();
    }
    syncFolder(parentFolder(m_target));
}
} // namespace core
