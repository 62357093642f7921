#include "core/journal/checksum.h"

#include <array>

namespace core
{
namespace
{
constexpr std::uint32_t polynomial = 0xedb88320u;

/// tables[i][b]: contribution of a byte b that is followed by i more bytes of the block (Kounavis and Berry 2005).
constexpr auto tables = [] {
    std::array<std::array<std::uint32_t, 256>, 8> made{};
    for (std::uint32_t b = 0; b < 256; ++b) {
        std::uint32_t crc = b;
        for (int bit = 0; bit < 8; ++bit)
            crc = (crc >> 1) ^ ((crc & 1) ? polynomial : 0);
        made[0][b] = crc;
    }
    for (std::size_t i = 1; i < made.size(); ++i)
        for (std::size_t b = 0; b < 256; ++b)
            made[i][b] = (made[i - 1][b] >> 8) ^ made[0][made[i - 1][b] & 0xff];
    return made;
}();
} // namespace

std::uint32_t checksum(std::string_view bytes, std::uint32_t seed)
{
    std::uint32_t crc = ~seed;
    const auto at = [&](std::size_t i) { return static_cast<std::uint8_t>(bytes[i]); };
    std::size_t i = 0;
    for (; i + 8 <= bytes.size(); i += 8) {
        std::uint32_t next = 0;
        for (std::size_t j = 0; j < 8; ++j)
            next ^= tables[7 - j][at(i + j) ^ (j < 4 ? (crc >> (8 * j)) & 0xff : 0)];
        crc = next;
    }
    for (; i < bytes.size(); ++i)
        crc = (crc >> 8) ^ tables[0][(crc ^ at(i)) & 0xff];
    return ~crc;
}
} // namespace core
