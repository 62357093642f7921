#pragma once

#include <cstdint>
#include <string_view>

namespace core
{
/// Returns the CRC-32 (ISO 3309, as in zlib and PNG). Processes eight bytes a step. `seed`: the checksum of the
/// preceding bytes.
std::uint32_t checksum(std::string_view bytes, std::uint32_t seed = 0);
} // namespace core
