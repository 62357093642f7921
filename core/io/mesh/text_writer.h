#pragma once

#include "core/util/atomic_file.h"

#include <charconv>
#include <string_view>
#include <type_traits>

namespace core::io
{
/// Writes text in the C locale. Floating-point numbers have the fewest digits that are read back to the same bits.
class TextWriter
{
public:
    explicit TextWriter(AtomicFile& out) : m_out(out) {}
    ~TextWriter() = default;
    TextWriter(const TextWriter&) = delete;
    TextWriter& operator=(const TextWriter&) = delete;

    TextWriter& operator<<(std::string_view text)
    {
        m_out.write(text);
        return *this;
    }
    TextWriter& operator<<(char character) { return *this << std::string_view(&character, 1); }
    template <typename Number>
    requires std::is_arithmetic_v<Number> TextWriter& operator<<(Number number)
    {
        char digits[64];
        const auto [end, error] = std::to_chars(digits, digits + sizeof digits, number);
        m_out.write({digits, static_cast<std::size_t>(end - digits)});
        return *this;
    }

private:
    AtomicFile& m_out;
};
} // namespace core::io
