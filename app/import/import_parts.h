#pragma once

#include "core/parts/part_list.h"

#include <optional>
#include <string>
#include <string_view>

namespace app
{
/// Largest size that packedParts() returns, bytes.
inline constexpr std::size_t maxPackedParts = core::PartList::maxParts * (core::PartList::maxNameBytes + 64);

/// Returns the list as bytes, for the import process's output.
std::string packedParts(const core::PartList& parts);
/// Returns the list that packedParts() turned into these bytes; nothing if they are not from packedParts().
std::optional<core::PartList> unpackedParts(std::string_view bytes);
} // namespace app
