// Source: FBX files written by many programs, and Blender Foundation, "FBX binary file format specification"
// (code.blender.org, 2013): a header of 27 bytes, then records, each a name followed by its properties.
#include "app/import/fbx_file.h"

#include <algorithm>
#include <charconv>
#include <cstdint>

namespace app
{
namespace
{
// followed by two blanks in the format; Assimp does not require them
constexpr std::string_view binaryStart = "Kaydara FBX Binary";

std::uint32_t wordAt(std::string_view bytes, std::size_t at)
{
    std::uint32_t word = 0;
    for (std::size_t i = 0; i < 4 && at + i < bytes.size(); ++i)
        word |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[at + i])) << (8 * i);
    return word;
}

/// Returns the integer after a key of a text file, e.g. in "FBXVersion: 7400".
int numberBehind(std::string_view rest)
{
    rest.remove_prefix(std::min(rest.find_first_not_of(": \t"), rest.size()));
    int number = 0;
    std::from_chars(rest.data(), rest.data() + rest.size(), number);
    return number;
}
} // namespace

bool isBinaryFbx(std::string_view bytes)
{
    return bytes.starts_with(binaryStart);
}

int fbxVersion(std::string_view bytes)
{
    constexpr std::size_t versionAt = 23, startSize = 1 << 16;
    if (isBinaryFbx(bytes))
        return static_cast<int>(std::min<std::uint32_t>(wordAt(bytes, versionAt), 1 << 20));
    constexpr std::string_view key = "FBXVersion";
    const std::string_view start = bytes.substr(0, startSize);
    const std::size_t at = start.find(key);
    return at == std::string_view::npos ? 0 : numberBehind(start.substr(at + key.size()));
}

std::size_t fbxSubdivisions(std::string_view bytes)
{
    constexpr std::string_view key = "Smoothness"; // 0: none, 1: hull, 2: hull and smooth surface, 3: smooth surface
    const bool isBinary = isBinaryFbx(bytes);
    std::size_t count = 0;
    for (std::size_t at = bytes.find(key); at != std::string_view::npos; at = bytes.find(key, at + 1)) {
        const std::string_view rest = bytes.substr(at + key.size());
        const std::uint32_t value = !isBinary ? static_cast<std::uint32_t>(std::max(numberBehind(rest), 0))
                                    : rest.starts_with('I') ? wordAt(rest, 1)
                                                            : 0;
        count += value == 2 || value == 3 ? 1 : 0;
    }
    return count;
}

std::size_t fbxNurbs(std::string_view bytes)
{
    constexpr std::string_view key = "NurbsSurfaceOrder"; // occurs once in each NURBS surface
    std::size_t count = 0;
    for (std::size_t at = bytes.find(key); at != std::string_view::npos; at = bytes.find(key, at + key.size()))
        ++count;
    return count;
}
} // namespace app
