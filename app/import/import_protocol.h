#pragma once

#include <algorithm>
#include <cstdint>

namespace app
{
/// The result of the process that reads further formats: this header, then points, colours, masks and triangles as core
/// has them, then importEnd. Both ends are the same program on the same machine.
struct ImportHeader
{
    /// Faulty: what kind, fault, unit, place, expected and found say.
    enum class Outcome : std::uint32_t { Read, Refused, Faulty, OutOfMemory, Outside };
    static constexpr std::uint32_t magicNumber = 0x464f5231;

    std::uint32_t magic = magicNumber;
    Outcome outcome = Outcome::Refused;
    std::uint64_t points = 0, colors = 0, masks = 0, triangles = 0, objects = 1;
    std::uint64_t repeatedCorners = 0, facesOfFewer = 0, animations = 0, subdivisions = 0, unreadNodes = 0;
    std::uint64_t place = 0, expected = 0, found = 0; ///< of a core::FileError
    std::uint32_t kind = 0, fault = 0, unit = 0;      ///< of a core::FileError, as numbers
    std::uint8_t materials = 0, textures = 0, poses = 0;
    char file[201] = {};    ///< which one is Faulty, against the folder of the one that is read; empty: that one
    char message[201] = {}; ///< why it was refused; the error's token; or the name of what is outside of its folder
};

inline constexpr std::uint32_t importEnd = 0x454e4421;

/// What the process may use for a file of that many bytes.
struct ImportLimits
{
    explicit ImportLimits(std::uint64_t fileSize)
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
