#include "core/io/mesh/text_scanner.h"

#include "core/io/mesh/number_parsing.h"

#include <algorithm>

namespace core::io
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
} // namespace

TextScanner::TextScanner(const FileBytes& file, const char* from, char comment)
    : m_file(file)
    , m_at(from == file.bytes.data() ? withoutMark(file.bytes).data() : from)
    , m_end(file.bytes.data() + withoutPadding(file.bytes).size())
    , m_comment(comment)
{
    m_end = std::max(m_end, m_at); // a header may be followed by a body that is all zeros
}

void TextScanner::skipBlanks()
{
    for (; m_at != m_end; ++m_at) {
        if (isBlank(*m_at))
            continue;
        if (m_comment != '\0' && *m_at == m_comment)
            m_at = std::find_if(m_at, m_end, isLineEnd);
        if (m_at == m_end || !isContinuation(m_at))
            return;
        ++m_at; // now at the line end that the backslash cancels
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
    while (m_at != m_end && !isBlank(*m_at) && !isLineEnd(*m_at) && !isContinuation(m_at) &&
           (m_comment == '\0' || *m_at != m_comment))
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
        fail(FileFault::Number, {});
    const auto value = parseFloat(word);
    if (!value)
        fail(FileErrorKind::NotANumber, word);
    return *value;
}

std::int64_t TextScanner::toInteger(std::string_view word) const
{
    if (word.empty())
        fail(FileFault::WholeNumber, {});
    const auto value = parseInteger(word);
    if (!value && parseDouble(word))
        fail(FileErrorKind::NotANumber, word);
    if (!value)
        fail(FileFault::WholeNumber, word);
    return *value;
}

void TextScanner::fail(FileErrorKind kind, std::string_view word) const
{
    throw errorAt(kind, word);
}

void TextScanner::fail(FileFault fault, std::string_view word, std::string_view wanted) const
{
    const FileError error = errorAt(FileErrorKind::Malformed, word);
    throw error.kind == FileErrorKind::Malformed ? malformed(fault, error, wanted) : error;
}

FileError TextScanner::errorAt(FileErrorKind kind, std::string_view word) const
{
    const bool atEnd = word.empty() ? m_at == m_end : word.data() + word.size() == m_end;
    const bool couldBeCut = kind == FileErrorKind::Malformed || kind == FileErrorKind::NotANumber;
    const char* const at = word.empty() ? m_at : word.data();
    return errorAtLine(atEnd && couldBeCut ? FileErrorKind::CutOff : kind, m_file, at, word);
}
} // namespace core::io
