#pragma once

#include "core/io/mesh/format.h"
#include "core/io/mesh/xml_namespaces.h"

#include <exception>
#include <functional>
#include <memory>
#include <optional>

struct XML_ParserStruct;

namespace core::io
{
/// The attributes of one element. Views are valid until the callback returns. Names have the form "name" or
/// "namespace|name".
class XmlAttributes
{
public:
    XmlAttributes(const FileBytes& file, const char** pairs, XmlNamespaces& namespaces)
        : m_file(file)
        , m_pairs(pairs)
        , m_namespaces(namespaces)
    {}

    /// Returns the attribute's value without surrounding blanks; empty if there is none.
    std::string_view text(std::string_view name) const;
    /// Returns the attribute's number. Throws FileError: NotANumber with the text, or Malformed with the name if there
    /// is none.
    float number(std::string_view name) const;
    std::uint32_t whole(std::string_view name) const;
    /// Returns the attribute's number; nothing if there is none. Throws FileError: NotANumber if it is not a whole
    /// number of 32 bits without sign.
    std::optional<std::uint32_t> wholeIfAny(std::string_view name) const;

    /// Returns the namespace that a prefix has at this element; empty if none.
    std::string_view spaceOf(std::string_view prefix) const { return m_namespaces.spaceOf(prefix); }

    [[noreturn]] void refuse(FileErrorKind kind, std::string_view token) const;
    [[noreturn]] void refuse(FileFault fault, std::string_view token) const;

private:
    const FileBytes& m_file;
    const char** m_pairs;
    XmlNamespaces& m_namespaces;
};

/// Parses XML from untrusted sources piece by piece, in UTF-8 or UTF-16, with the library expat. Document types are
/// refused. So there are no entities except the five predefined ones, and no other file is ever opened. A tag may be 1
/// MiB long. Names with an undeclared prefix have no namespace. Errors have the line.
class XmlReader
{
public:
    using Begin = std::function<void(std::string_view name, const XmlAttributes& attributes)>;
    using End = std::function<void(std::string_view name)>;
    using Text = std::function<void(std::string_view piece)>;

    static constexpr int usualDepth = 64;

    /// `text` receives the text between tags in UTF-8, piece by piece. `maxDepth`: how deep elements may be nested.
    XmlReader(const FileBytes& file, Begin begin, End end, Text text = {}, int maxDepth = usualDepth);

    /// Parses a piece; the last one is empty. Throws FileError, and whatever the callbacks throw.
    void take(std::string_view piece);
    /// Returns the line that is being parsed, from 1.
    std::uint64_t line() const;

private:
    struct Callbacks;
    void guarded(const std::function<void()>& work);
    [[noreturn]] void refuse(FileFault fault, std::string_view token = {}) const;

    const FileBytes& m_file;
    XmlNamespaces m_namespaces;
    Begin m_begin;
    End m_end;
    Text m_text;
    std::unique_ptr<XML_ParserStruct, void (*)(XML_ParserStruct*)> m_parser;
    int m_depth = 0, m_maxDepth;
    std::uint64_t m_given = 0; ///< bytes passed to the parser so far
    std::exception_ptr m_problem;
};
} // namespace core::io
