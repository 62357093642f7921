#pragma once

#include <algorithm>
#include <cstdint>

namespace app
{
/// Header of the import process's output. It is followed by points, colours, masks, labels and triangles in core's
/// memory layout, the bytes of the list of parts (import_parts.h), and importEnd. Writer and reader are the same
/// program on the same machine.
struct ImportHeader
{
    /// Faulty: `kind`, `fault`, `unit`, `place`, `expected` and `found` describe a core::FileError.
    enum class Outcome : std::uint32_t { Read, Refused, Faulty, OutOfMemory, Outside };
    static constexpr std::uint32_t magicNumber = 0x464f5231;

    std::uint32_t magic = magicNumber;
    Outcome outcome = Outcome::Refused;
    std::uint64_t points = 0, colors = 0, masks = 0, labels = 0, triangles = 0, partBytes = 0, objects = 1;
    std::uint64_t repeatedCorners = 0, facesOfFewer = 0, animations = 0, subdivisions = 0, unreadNodes = 0,
                  hiddenObjects = 0;
    std::uint64_t place = 0, expected = 0, found = 0; ///< fields of a core::FileError
    std::uint32_t kind = 0, fault = 0, unit = 0;      ///< fields of a core::FileError, as numbers
    std::uint8_t materials = 0, textures = 0, poses = 0;
    char file[201] = {}; ///< the faulty file's path relative to the folder of the file read; empty: the file read
    /// reason for a refusal, token of a core::FileError, or name of a file outside of the folder
    char message[201] = {};
};

inline constexpr std::uint32_t importEnd = 0x454e4421;

/// Resources that the import process may use for a file of `fileSize` bytes.
struct ImportLimits
{
    explicit ImportLimits(std::uint64_t fileSize)
        : memory((std::uint64_t(512) << 20) + 40 * fileSize)
        , seconds(30 + fileSize / (std::uint64_t(1) << 19))
        , points(std::min(std::uint64_t(1) << 27, (std::uint64_t(1) << 20) + 16 * fileSize))
        , triangles(2 * points)
    {}

    std::uint64_t memory;  ///< bytes, in addition to what the process uses at its start
    std::uint64_t seconds; ///< CPU time; the wall-clock limit is twice as long
    std::uint64_t points, triangles;
};
} // namespace app
