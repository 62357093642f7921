#pragma once

#include "core/io/mesh/format.h"

namespace core::io
{
/// Reads a text file word by word and line by line. Lines end with \n, \r\n or \r; a backslash at the end of a line
/// continues it. Skips a byte order mark at the file's start and padding at its end. Errors have the line. An error at
/// the very end of the file is reported as CutOff.
class TextScanner
{
public:
    /// `comment`: skips from this character to the end of a line.
    TextScanner(const FileBytes& file, const char* from, char comment = '\0');

    /// Returns the next word on this line; empty at the line's end.
    std::string_view word();
    /// Returns the next word on this line or a later one; empty at the end of the file.
    std::string_view wordAnywhere();
    /// Moves to the start of the next line. Returns false at the end of the file.
    bool nextLine();
    /// Moves past blanks. Returns whether no further word follows on this line.
    bool atLineEnd();
    bool atFileEnd() const { return m_at == m_end; }
    const char* position() const { return m_at; }

    /// Returns the next word on this line as a finite number, rounded to the nearest float32.
    float number() { return toNumber(word()); }
    float toNumber(std::string_view word) const;
    /// Returns the word as a number. The word must be a whole number and nothing else.
    std::int64_t toInteger(std::string_view word) const;

    /// Throws an error about `word`, a part of the file; empty if something is missing at the current position.
    [[noreturn]] void fail(FileErrorKind kind, std::string_view word) const;
    /// Throws Malformed. The fault names what was expected instead of the word.
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
