#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace core
{
/// Detects changes to a file: a 64-bit FNV-1a hash. Not cryptographic.
class Fingerprint
{
public:
    void add(std::span<const std::uint8_t> bytes)
    {
        for (const std::uint8_t byte : bytes)
            m_hash = (m_hash ^ byte) * 0x100000001b3;
    }
    void add(std::uint32_t word)
    {
        for (int shift = 0; shift < 32; shift += 8)
            add(std::array{static_cast<std::uint8_t>(word >> shift)});
    }
    /// Returns the hash as 16 hexadecimal digits.
    std::string text() const
    {
        std::string digits;
        for (int shift = 60; shift >= 0; shift -= 4)
            digits += "0123456789abcdef"[m_hash >> shift & 15];
        return digits;
    }

private:
    std::uint64_t m_hash = 0xcbf29ce484222325;
};

inline bool isFingerprint(std::string_view text)
{
    return text.size() == 16 && text.find_first_not_of("0123456789abcdef") == std::string_view::npos;
}
} // namespace core
