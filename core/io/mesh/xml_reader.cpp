#include "core/io/mesh/xml_reader.h"

#include "core/io/mesh/number_parsing.h"

#include <expat.h>

#include <algorithm>
#include <limits>
#include <new>

namespace core::io
{
namespace
{
constexpr std::uint64_t longestTag = 1 << 20;
} // namespace

std::string_view XmlAttributes::text(std::string_view name) const
{
    for (const char** pair = m_pairs; *pair; pair += 2)
        if (m_namespaces.attribute(pair[0]) == name) {
            constexpr const char* blanks = " \t\r\n";
            const std::string_view value(pair[1]);
            const std::size_t first = value.find_first_not_of(blanks);
            return first == std::string_view::npos ? std::string_view()
                                                   : value.substr(first, value.find_last_not_of(blanks) + 1 - first);
        }
    return {};
}

float XmlAttributes::number(std::string_view name) const
{
    const std::string_view word = text(name);
    if (word.empty())
        refuse(FileFault::Missing, name);
    const auto value = parseFloat(word);
    if (!value)
        refuse(FileErrorKind::NotANumber, word);
    return *value;
}

std::optional<std::uint32_t> XmlAttributes::wholeIfAny(std::string_view name) const
{
    const std::string_view word = text(name);
    if (word.empty())
        return std::nullopt;
    const auto value = parseInteger(word);
    if (!value || *value < 0 || *value > std::numeric_limits<std::uint32_t>::max())
        refuse(FileErrorKind::NotANumber, word);
    return static_cast<std::uint32_t>(*value);
}

std::uint32_t XmlAttributes::whole(std::string_view name) const
{
    const auto value = wholeIfAny(name);
    if (!value)
        refuse(FileFault::Missing, name);
    return *value;
}

void XmlAttributes::refuse(FileErrorKind kind, std::string_view token) const
{
    throw errorWithToken(kind, m_file, token);
}

void XmlAttributes::refuse(FileFault fault, std::string_view token) const
{
    throw malformed(fault, errorWithToken({}, m_file, token));
}

/// The callbacks for expat. An exception must not pass through expat: it is stored, and parsing stops.
struct XmlReader::Callbacks
{
    static void begin(void* self, const char* name, const char** pairs)
    {
        auto& reader = *static_cast<XmlReader*>(self);
        reader.guarded([&] {
            if (++reader.m_depth > reader.m_maxDepth)
                reader.refuse(FileFault::XmlTooDeep);
            reader.m_namespaces.begin(pairs);
            // Copied, because the view becomes invalid when attributes are read.
            const std::string whole(reader.m_namespaces.element(name));
            reader.m_begin(whole, XmlAttributes(reader.m_file, pairs, reader.m_namespaces));
        });
    }
    static void end(void* self, const char* name)
    {
        auto& reader = *static_cast<XmlReader*>(self);
        --reader.m_depth;
        reader.guarded([&] {
            reader.m_end(reader.m_namespaces.element(name));
            reader.m_namespaces.end();
        });
    }
    static void text(void* self, const char* piece, int size)
    {
        auto& reader = *static_cast<XmlReader*>(self);
        reader.guarded([&] { reader.m_text({piece, static_cast<std::size_t>(size)}); });
    }
    static void documentType(void* self, const char*, const char*, const char*, int)
    {
        auto& reader = *static_cast<XmlReader*>(self);
        reader.guarded([&] { reader.refuse(FileFault::XmlDocumentType); });
    }
};

XmlReader::XmlReader(const FileBytes& file, Begin begin, End end, Text text, int maxDepth)
    : m_file(file)
    , m_begin(std::move(begin))
    , m_end(std::move(end))
    , m_text(std::move(text))
    , m_parser(XML_ParserCreate(nullptr), &XML_ParserFree)
    , m_maxDepth(maxDepth)
{
    if (!m_parser)
        throw std::bad_alloc();
    XML_SetUserData(m_parser.get(), this);
    XML_SetElementHandler(m_parser.get(), &Callbacks::begin, &Callbacks::end);
    if (m_text)
        XML_SetCharacterDataHandler(m_parser.get(), &Callbacks::text);
    XML_SetStartDoctypeDeclHandler(m_parser.get(), &Callbacks::documentType);
}

void XmlReader::guarded(const std::function<void()>& work)
{
    if (m_problem)
        return;
    try {
        work();
    } catch (FileError& error) {
        if (error.place.unit == FilePlace::Unit::None)
            error.place = {FilePlace::Unit::Line, line()};
        m_problem = std::make_exception_ptr(error);
    } catch (...) {
        m_problem = std::current_exception();
    }
    if (m_problem)
        XML_StopParser(m_parser.get(), XML_FALSE);
}

void XmlReader::take(std::string_view piece)
{
    m_given += piece.size();
    const XML_Status status = XML_Parse(m_parser.get(), piece.data(), static_cast<int>(piece.size()), piece.empty());
    if (m_problem)
        std::rethrow_exception(m_problem);
    if (status != XML_STATUS_OK && XML_GetErrorCode(m_parser.get()) == XML_ERROR_NO_MEMORY)
        throw std::bad_alloc();
    const auto understood = static_cast<std::uint64_t>(std::max<XML_Index>(0, XML_GetCurrentByteIndex(m_parser.get())));
    if (status != XML_STATUS_OK)
        refuse(FileFault::XmlSyntax, XML_ErrorString(XML_GetErrorCode(m_parser.get())));
    if (m_given > understood + longestTag)
        refuse(FileFault::XmlLongTag);
}

std::uint64_t XmlReader::line() const
{
    return XML_GetCurrentLineNumber(m_parser.get());
}

void XmlReader::refuse(FileFault fault, std::string_view token) const
{
    FileError error = malformed(fault, errorWithToken({}, m_file, token));
    error.place = {FilePlace::Unit::Line, line()};
    throw error;
}
} // namespace core::io
