#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <string>

namespace core::io
{
/// Returns the number at `at`, which need not be aligned.
template <typename Number> Number load(const char* at, std::endian order)
{
    std::array<char, sizeof(Number)> bytes;
    std::copy_n(at, sizeof(Number), bytes.begin());
    if (order != std::endian::native)
        std::reverse(bytes.begin(), bytes.end());
    return std::bit_cast<Number>(bytes);
}

template <typename Number> std::array<char, sizeof(Number)> littleEndian(Number number)
{
    auto bytes = std::bit_cast<std::array<char, sizeof(Number)>>(number);
    if (std::endian::native == std::endian::big)
        std::reverse(bytes.begin(), bytes.end());
    return bytes;
}

/// Appends the number, little-endian.
template <typename Number> void append(std::string& out, Number number)
{
    const auto bytes = littleEndian(number);
    out.append(bytes.data(), bytes.size());
}

/// Stores the number at `at` in little-endian order and advances `at` past it.
template <typename Number> void store(char*& at, Number number)
{
    at = std::ranges::copy(littleEndian(number), at).out;
}
} // namespace core::io
