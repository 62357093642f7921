#pragma once

#include "core/io/mesh/format.h"

#include <optional>

namespace core::io
{
/// Returns the content of a buffer's uri: base64 data in the uri itself, or `bytes` bytes of a file beside `file`.
/// Throws FileError. OutsideFolder: the uri is not a relative path, or leaves the file's folder after decoding percent
/// signs and resolving dots and links. CutOff: there are fewer bytes. Errors in reading the other file are thrown, too.
std::string gltfBuffer(const FileBytes& file, std::string_view uri, std::uint64_t bytes);
} // namespace core::io
