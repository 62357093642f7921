#pragma once

#include <cstdint>
#include <string_view>

namespace core
{
/// CRC-32 (ISO 3309, as zlib and PNG have it), eight bytes a step. `seed`: of what comes before.
std::uint32_t checksum(std::string_view bytes, std::uint32_t seed = 0);
} // namespace core
