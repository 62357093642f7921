#pragma once

#include <algorithm>
#include <cstdint>

namespace app
{
/// What the process that reads foreign formats answers: this head, then points, colours and triangles as core has them,
/// then foreignEnd. Both ends are the same program on the same machine.
struct ForeignHead
{
    enum class Outcome : std::uint32_t { Read, Refused, OutOfMemory, Outside };
    static constexpr std::uint32_t magicNumber = 0x464f5231;

    std::uint32_t magic = magicNumber;
    Outcome outcome = Outcome::Refused;
    std::uint64_t points = 0, colors = 0, triangles = 0, objects = 1;
    std::uint8_t materials = 0, textures = 0, poses = 0;
    char words[41] = {}; ///< why it was refused, or the name of what is outside of its folder
};

inline constexpr std::uint32_t foreignEnd = 0x454e4421;

/// What the process may use for a file of that many bytes.
struct ForeignLimits
{
    explicit ForeignLimits(std::uint64_t fileSize)
        : memory((std::uint64_t(512) << 20) + 40 * fileSize)
        , seconds(30 + fileSize / (std::uint64_t(1) << 19))
        , points(std::min(std::uint64_t(1) << 27, (std::uint64_t(1) << 20) + 16 * fileSize))
        , triangles(2 * points)
    {}

    std::uint64_t memory;  ///< bytes, beyond what the program takes anyway
    std::uint64_t seconds; ///< of the processor; twice as long by the clock
    std::uint64_t points, triangles;
};
} // namespace app
