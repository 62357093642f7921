#pragma once

#include <cstdint>
#include <limits>

namespace core
{
/// Index of a vertex, edge, half-edge or face in the mesh's arrays; stable while the document has history.
using Slot = std::uint32_t;
inline constexpr Slot noSlot = std::numeric_limits<Slot>::max();
} // namespace core
