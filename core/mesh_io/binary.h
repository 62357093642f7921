#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <string>

namespace core::mesh_io
{
/// The number at `at`, which need not be aligned.
template <typename Number> Number load(const char* at, std::endian order)
{
    std::array<char, sizeof(Number)> bytes;
    std::copy_n(at, sizeof(Number), bytes.begin());
    if (order != std::endian::native)
        std::reverse(bytes.begin(), bytes.end());
    return std::bit_cast<Number>(bytes);
}

/// Appends the number, little-endian.
template <typename Number> void append(std::string& out, Number number)
{
    auto bytes = std::bit_cast<std::array<char, sizeof(Number)>>(number);
    if (std::endian::native == std::endian::big)
        std::reverse(bytes.begin(), bytes.end());
    out.append(bytes.data(), bytes.size());
}
} // namespace core::mesh_io
