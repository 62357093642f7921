#include "text_scanner.h"

#include <charconv>
#include <cmath>

namespace core::mesh_io
{
namespace
{
bool isLineEnd(char c)
{
    return c == '\n' || c == '\r';
}

bool isBlank(char c)
{
    return c == ' ' || c == '\t' || c == '\v' || c == '\f';
}

const char* afterPlus(std::string_view word)
{
    return word.data() + (word.size() > 1 && word[0] == '+' && word[1] != '-' ? 1 : 0);
}

/// A number beyond float32's range: rounds to zero or a denormal, or is infinite (NaN returned).
float farNumber(std::string_view word)
{
    double value = 0;
    const auto [end, error] = std::from_chars(afterPlus(word), word.data() + word.size(), value);
    const bool tiny = error == std::errc() ? std::abs(value) < 1 : word.find('-', 1) != std::string_view::npos;
    if (!tiny)
        return std::nanf("");
    return error == std::errc() ? static_cast<float>(value) : word.front() == '-' ? -0.0f : 0.0f;
}
} // namespace

void TextScanner::skipBlanks()
{
    for (; m_at != m_end; ++m_at) {
        if (isBlank(*m_at))
            continue;
        if (!isContinuation(m_at))
            return;
        ++m_at; // now at the line end that the backslash takes away
        if (*m_at == '\r' && m_at + 1 != m_end && m_at[1] == '\n')
            ++m_at;
    }
}

bool TextScanner::isContinuation(const char* at) const
{
    return *at == '\\' && at + 1 != m_end && isLineEnd(at[1]);
}

std::string_view TextScanner::word()
{
    skipBlanks();
    const char* const first = m_at;
    while (m_at != m_end && !isBlank(*m_at) && !isLineEnd(*m_at) && !isContinuation(m_at))
        ++m_at;
    return {first, static_cast<std::size_t>(m_at - first)};
}

std::string_view TextScanner::wordAnywhere()
{
    for (;;) {
        const std::string_view found = word();
        if (!found.empty() || !nextLine())
            return found;
    }
}

bool TextScanner::nextLine()
{
    while (m_at != m_end && !isLineEnd(*m_at))
        ++m_at;
    if (m_at == m_end)
        return false;
    m_at += *m_at == '\r' && m_at + 1 != m_end && m_at[1] == '\n' ? 2 : 1;
    return m_at != m_end;
}

bool TextScanner::atLineEnd()
{
    skipBlanks();
    return m_at == m_end || isLineEnd(*m_at);
}

float TextScanner::toNumber(std::string_view word) const
{
    if (word.empty())
        fail(FileErrorKind::Malformed, {});
    const char* const last = word.data() + word.size();
    float value = 0;
    const auto [end, error] = std::from_chars(afterPlus(word), last, value);
    if (error == std::errc::result_out_of_range && end == last)
        value = farNumber(word);
    else if (error != std::errc() || end != last)
        fail(FileErrorKind::NotANumber, word);
    if (!std::isfinite(value))
        fail(FileErrorKind::NotANumber, word);
    return value;
}

std::int64_t TextScanner::toInteger(std::string_view word) const
{
    if (word.empty())
        fail(FileErrorKind::Malformed, {});
    const char* const last = word.data() + word.size();
    std::int64_t value = 0;
    const auto [end, error] = std::from_chars(afterPlus(word), last, value);
    if (error != std::errc() || end != last)
        fail(FileErrorKind::NotANumber, word);
    return value;
}

void TextScanner::fail(FileErrorKind kind, std::string_view word) const
{
    const bool atEnd = word.empty() ? m_at == m_end : word.data() + word.size() == m_end;
    const bool couldBeCut = kind == FileErrorKind::Malformed || kind == FileErrorKind::NotANumber;
    const char* const at = word.empty() ? m_at : word.data();
    throw errorAtLine(atEnd && couldBeCut ? FileErrorKind::CutOff : kind, m_file, at, word);
}
} // namespace core::mesh_io
