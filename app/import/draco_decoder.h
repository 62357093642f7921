#pragma once

#include "core/io/draco_stream.h"

namespace app
{
/// Decodes a stream by Google's Draco. Throws std::bad_alloc. For a process that may die of it: broken streams may do
/// anything to the library.
std::optional<core::DracoMesh> decodedDraco(std::string_view stream, std::span<const std::uint32_t> ids);
} // namespace app
