#pragma once

#include "core/util/file_error.h"

#include <filesystem>
#include <span>

namespace core::io
{
/// A file opened for reading. It stays the same file even if the path is replaced meanwhile. Throws FileError.
/// Thread-safe.
class InputFile
{
public:
    explicit InputFile(const std::filesystem::path& path);
    ~InputFile();
    InputFile(const InputFile&) = delete;
    InputFile& operator=(const InputFile&) = delete;

    /// Reads bytes from `offset` on and returns their number. It is less than requested only at the file's end.
    std::size_t read(std::uint64_t offset, std::span<char> into) const;

private:
    const std::filesystem::path& m_path;
    int m_descriptor;
};
} // namespace core::io
