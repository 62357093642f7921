#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace core
{
/// Returns the path as calls of the system and std::ifstream take it. On Windows, a path that may exceed MAX_PATH
/// becomes absolute and gets the prefix \\?\ of long paths; other paths, and those of other systems, are unchanged.
std::filesystem::path systemPath(const std::filesystem::path& path);

/// Returns the path that a name in UTF-8 means. On Windows, std::filesystem would take each of its bytes for a
/// character.
inline std::filesystem::path pathOfUtf8(std::string_view name)
{
    return std::u8string(name.begin(), name.end());
}

/// Returns the folder that holds a file; "." for a name without a folder.
inline std::filesystem::path parentFolder(const std::filesystem::path& file)
{
    return file.has_parent_path() ? file.parent_path() : ".";
}

struct FileStatus
{
    std::filesystem::file_type type = std::filesystem::file_type::none;
    std::uint64_t size = 0; ///< bytes; 0 if it is no regular file
    int systemCode = 0;     ///< reason if type is none or unknown (system_code.h)
};

/// Returns what is at a path, with links followed. In contrast to std::filesystem it takes long paths on Windows.
FileStatus fileStatus(const std::filesystem::path& path);
} // namespace core
