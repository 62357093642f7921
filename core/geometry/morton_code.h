#pragma once

#include <array>
#include <cstdint>

namespace core
{
inline constexpr int mortonBits = 21; ///< bits per coordinate: three coordinates fill 63 bits

/// Interleaves the lower 21 bits of three coordinates: returns the position on a Morton curve (Morton 1966).
inline std::uint64_t mortonCode(const std::array<std::uint64_t, 3>& cell)
{
    const auto spread = [](std::uint64_t x) { // puts two zero bits between neighbouring bits
        x &= 0x1fffff;
        x = (x | x << 32) & 0x1f00000000ffffu;
        x = (x | x << 16) & 0x1f0000ff0000ffu;
        x = (x | x << 8) & 0x100f00f00f00f00fu;
        x = (x | x << 4) & 0x10c30c30c30c30c3u;
        return (x | x << 2) & 0x1249249249249249u;
    };
    return spread(cell[0]) | spread(cell[1]) << 1 | spread(cell[2]) << 2;
}
} // namespace core
