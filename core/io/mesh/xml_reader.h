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
/// The attributes of one element; views last as long as its begin() does. Names: "name", or "namespace|name".
class XmlAttributes
{
public:
    XmlAttributes(const FileBytes& file, const char** pairs, XmlNamespaces& namespaces)
        : m_file(file)
        , m_pairs(pairs)
        , m_namespaces(namespaces)
    {}

    /// Without blanks around it; empty if there is none.
    std::string_view text(std::string_view name) const;
    /// Throw FileError: NotANumber with the text, or Malformed with the name if there is none.
    float number(std::string_view name) const;
    std::uint32_t whole(std::string_view name) const;
    /// Empty if there is none.
    std::optional<std::uint32_t> wholeIfAny(std::string_view name) const;

    /// Returns the namespace that a prefix stands for here; empty if none.
    std::string_view spaceOf(std::string_view prefix) const { return m_namespaces.spaceOf(prefix); }

    [[noreturn]] void refuse(FileErrorKind kind, std::string_view token) const;
    [[noreturn]] void refuse(FileFault fault, std::string_view token) const;

private:
    const FileBytes& m_file;
    const char** m_pairs;
    XmlNamespaces& m_namespaces;
};

/// Strangers' XML, parsed piece by piece by a library (expat), in UTF-8 or UTF-16. There are no document types, so
/// there are no entities but the five, and nothing outside is ever opened; elements lie at most 64 deep, and no tag is
/// longer than 1 MiB. Names with a prefix that nothing declares have no namespace. Errors name the line.
class XmlReader
{
public:
    using Begin = std::function<void(std::string_view name, const XmlAttributes& attributes)>;
    using End = std::function<void(std::string_view name)>;
    using Text = std::function<void(std::string_view piece)>;

    /// `text` gets what stands between tags, in UTF-8, piece by piece.
    XmlReader(const FileBytes& file, Begin begin, End end, Text text = {});

    /// The last piece is empty. Throws FileError, and what the three functions throw.
    void take(std::string_view piece);
    /// Returns the line that is being parsed, from 1.
    std::uint64_t line() const;

private:
    struct Callbacks;
    void guarded(const std::function<void()>& work);
    [[noreturn]] void refuse(FileFault fault) const;

    const FileBytes& m_file;
    XmlNamespaces m_namespaces;
    Begin m_begin;
    End m_end;
    Text m_text;
    std::unique_ptr<XML_ParserStruct, void (*)(XML_ParserStruct*)> m_parser;
    int m_depth = 0;
    std::uint64_t m_given = 0; ///< bytes
    std::exception_ptr m_problem;
};
} // namespace core::io
