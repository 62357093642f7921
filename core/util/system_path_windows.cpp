// Source: Microsoft Learn, "Maximum Path Length Limitation", "Naming Files, Paths, and Namespaces".
#include "core/util/system_path.h"

#include "core/util/system_code.h"
#include "core/util/system_file_windows.h"

#include <string_view>

namespace core
{
namespace
{
constexpr std::wstring_view longPrefix = LR"(\\?\)", devicePrefix = LR"(\\.\)", share = LR"(\\)",
                            longShare = LR"(\\?\UNC\)";
/// Longest path that every call takes without a prefix: the system keeps room for a name of 8.3 in a new folder.
constexpr std::size_t maxPlain = MAX_PATH - 13;

/// Returns the absolute path without "." and "..", with backslashes. Empty: the system cannot tell it.
std::wstring absolutePath(const std::wstring& path)
{
    std::wstring full(GetFullPathNameW(path.c_str(), 0, nullptr, nullptr), '\0');
    full.resize(GetFullPathNameW(path.c_str(), static_cast<DWORD>(full.size()), full.data(), nullptr));
    return full;
}
} // namespace

std::filesystem::path systemPath(const std::filesystem::path& path)
{
    const std::wstring& text = path.native();
    if (text.empty() || text.starts_with(longPrefix) || text.starts_with(devicePrefix))
        return path;
    if (path.is_absolute() && text.size() <= maxPlain)
        return path;
    const std::wstring full = absolutePath(text);
    if (full.size() <= maxPlain)
        return path;
    return full.starts_with(share) ? std::wstring(longShare) + full.substr(share.size())
                                   : std::wstring(longPrefix) + full;
}

/// Opens the file only to ask, for which no rights are needed: so links are followed.
FileStatus fileStatus(const std::filesystem::path& path)
{
    using Type = std::filesystem::file_type;
    const ScopedHandle file(CreateFileW(systemPath(path).c_str(), FILE_READ_ATTRIBUTES, shareAll, nullptr,
                                        OPEN_EXISTING, FILE_FLAG_BACKUP_SEMANTICS, nullptr));
    if (!file) {
        const auto problem = static_cast<int>(GetLastError());
        const bool isMissing =
            problem == ERROR_INVALID_NAME || isSystemCode(problem, std::errc::no_such_file_or_directory);
        return {isMissing ? Type::not_found : Type::none, 0, problem};
    }
    if (const DWORD type = GetFileType(file.get()); type != FILE_TYPE_DISK)
        return {type == FILE_TYPE_CHAR ? Type::character : type == FILE_TYPE_PIPE ? Type::fifo : Type::unknown, 0, 0};
    BY_HANDLE_FILE_INFORMATION info{};
    if (!GetFileInformationByHandle(file.get(), &info))
        return {Type::unknown, 0, static_cast<int>(GetLastError())};
    if (info.dwFileAttributes & FILE_ATTRIBUTE_DIRECTORY)
        return {Type::directory, 0, 0};
    return {Type::regular, std::uint64_t(info.nFileSizeHigh) << 32 | info.nFileSizeLow, 0};
}
} // namespace core
