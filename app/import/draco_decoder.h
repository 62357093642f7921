#pragma once

#include "core/io/draco_stream.h"

namespace app
{
/// Decodes a stream with Google's Draco library. Throws std::bad_alloc. Call it only in a process that may crash:
/// broken streams may do anything to the library.
std::optional<core::DracoMesh> decodedDraco(std::string_view stream, std::span<const std::uint32_t> ids);
} // namespace app
