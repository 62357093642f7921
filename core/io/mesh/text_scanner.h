#pragma once

#include "core/io/mesh/format.h"

namespace core::io
{
/// Reads the words of a text file, line by line. Lines end with \n, \r\n or \r; a backslash at the end of a line
/// continues it. Skips a byte order mark at the file's start and padding at its end. Errors name the line. An error at
/// the very end of the file is CutOff.
class TextScanner
{
public:
    /// `comment`: skips from this character to the end of a line.
    TextScanner(const FileBytes& file, const char* from, char comment = '\0');

    /// The next word on this line; empty at its end.
    std::string_view word();
    /// The next word on this line or a later one; empty at the end of the file.
    std::string_view wordAnywhere();
    /// To the start of the next line. False at the end of the file.
    bool nextLine();
    /// No further word on this line. Leaves the position there.
    bool atLineEnd();
    bool atFileEnd() const { return m_at == m_end; }
    const char* position() const { return m_at; }

    /// Next word on this line, as a finite number, rounded to the nearest float32.
    float number() { return toNumber(word()); }
    float toNumber(std::string_view word) const;
    /// The word must be a whole number and nothing else.
    std::int64_t toInteger(std::string_view word) const;

    /// `word` is what is wrong: a part of the file, or empty for what is missing here.
    [[noreturn]] void fail(FileErrorKind kind, std::string_view word) const;
    /// Throws Malformed; the fault says what was expected in the word's place.
    [[noreturn]] void fail(FileFault fault, std::string_view word, std::string_view wanted = {}) const;

private:
    FileError errorAt(FileErrorKind kind, std::string_view word) const;
    void skipBlanks();
    bool isContinuation(const char* at) const;

    FileBytes m_file;
    const char* m_at;
    const char* m_end;
    char m_comment;
};
} // namespace core::io
