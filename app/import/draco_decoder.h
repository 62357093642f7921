#pragma once

#include "core/io/draco_stream.h"

namespace app
{
/// Decodes a stream with Google's Draco library. `ids`: unique ids of the attributes to be decoded; missing ones are
/// skipped. Returns nothing if the stream is invalid. Throws std::bad_alloc. Must be called only in a process that may
/// crash, because broken streams can crash the library.
std::optional<core::DracoMesh> decodedDraco(std::string_view stream, std::span<const std::uint32_t> ids);
} // namespace app
