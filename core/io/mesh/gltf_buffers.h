#pragma once

#include "core/io/mesh/format.h"

#include <optional>

namespace core::io
{
/// What a buffer's uri stands for: base64 in the uri itself, or a file beside `file`, of which `bytes` are read. Throws
/// FileError: OutsideFolder for anything that is not in the file's folder, or below it, when percent signs, dots and
/// links are followed; CutOff with fewer bytes, and what reading the other file meets.
std::string gltfBuffer(const FileBytes& file, std::string_view uri, std::uint64_t bytes);
} // namespace core::io
