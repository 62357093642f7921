#pragma once

#include "core/util/file_error.h"

#include <filesystem>
#include <span>

namespace core::io
{
/// A file opened for reading, the same one throughout, whatever the path becomes meanwhile. Throws FileError.
/// Thread-safe.
class InputFile
{
public:
    explicit InputFile(const std::filesystem::path& path);
    ~InputFile();
    InputFile(const InputFile&) = delete;
    InputFile& operator=(const InputFile&) = delete;

    /// How many bytes from `offset` on were read: fewer than asked for only at the file's end.
    std::size_t read(std::uint64_t offset, std::span<char> into) const;

private:
    const std::filesystem::path& m_path;
    int m_descriptor;
};
} // namespace core::io
