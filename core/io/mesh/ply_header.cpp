#include "core/io/mesh/ply_header.h"

#include "core/io/mesh/text_scanner.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <set>

namespace core::io
{
namespace
{
struct TypeName
{
    std::string_view name;
    PlyType type;
};
constexpr std::array typeNames{
    TypeName{"char", PlyType::Int8},      TypeName{"int8", PlyType::Int8},     TypeName{"uchar", PlyType::Uint8},
    TypeName{"uint8", PlyType::Uint8},    TypeName{"short", PlyType::Int16},   TypeName{"int16", PlyType::Int16},
    TypeName{"ushort", PlyType::Uint16},  TypeName{"uint16", PlyType::Uint16}, TypeName{"int", PlyType::Int32},
    TypeName{"int32", PlyType::Int32},    TypeName{"uint", PlyType::Uint32},   TypeName{"uint32", PlyType::Uint32},
    TypeName{"float", PlyType::Float},    TypeName{"float32", PlyType::Float}, TypeName{"double", PlyType::Double},
    TypeName{"float64", PlyType::Double},
};

class HeaderReader
{
public:
    explicit HeaderReader(const FileBytes& file)
        : m_file(file)
        , m_text(file, file.bytes.data())
        , m_linesEndBackwards(withoutMark(file.bytes).starts_with("ply\n\r") &&
                              !withoutMark(file.bytes).starts_with("ply\n\r\n"))
    {}

    PlyHeader read()
    {
        bool hasFormat = false;
        while (nextLine()) {
            const char* const line = m_text.position();
            const std::string_view keyword = m_text.word();
            if (keyword == "end_header")
                break;
            if (keyword == "format")
                hasFormat = readFormat();
            else if (keyword == "element")
                readElement(line);
            else if (keyword == "property")
                readProperty();
        } // other lines are comments or unknown keywords
        if (!hasFormat)
            m_text.fail(FileFault::Keyword, {}, "format");
        m_text.nextLine();
        m_header.body = m_text.position() + (m_linesEndBackwards && !m_text.atFileEnd() ? 1 : 0);
        return std::move(m_header);
    }

private:
    bool nextLine()
    {
        if (!m_text.nextLine())
            throw malformed(FileFault::Keyword, errorAtLine({}, m_file, m_text.position()), "end_header");
        return true;
    }

    bool readFormat()
    {
        constexpr std::array<std::string_view, 3> names{"ascii", "binary_little_endian", "binary_big_endian"};
        const std::string_view word = m_text.word();
        const auto found = std::ranges::find(names, word);
        if (found == names.end())
            m_text.fail(FileFault::PlyEncoding, word);
        m_header.encoding = static_cast<PlyEncoding>(found - names.begin());
        return true;
    }

    void readElement(const char* line)
    {
        const std::string_view name = m_text.word();
        const std::string_view count = m_text.word();
        if (name.empty() || !m_names.insert(name).second)
            m_text.fail(name.empty() ? FileFault::Name : FileFault::Repeated, name);
        const std::int64_t number = m_text.toInteger(count);
        if (number < 0)
            m_text.fail(FileFault::Count, count);
        m_header.elements.push_back({name, static_cast<std::uint64_t>(number), {}, line});
    }

    void readProperty()
    {
        if (m_header.elements.empty())
            throw malformed(FileFault::ElementFirst, errorAtLine({}, m_file, m_text.position(), "property"));
        PlyProperty property;
        std::string_view word = m_text.word();
        if (word == "list") {
            property.countType = toType(m_text.word());
            if (!isWhole(*property.countType))
                throw malformed(FileFault::WholeNumberType, errorAtLine({}, m_file, m_text.position(), "list"));
            word = m_text.word();
        }
        property.type = toType(word);
        property.name = m_text.word();
        if (property.name.empty())
            m_text.fail(FileFault::Name, {});
        m_header.elements.back().properties.push_back(property);
    }

    PlyType toType(std::string_view word) const
    {
        const auto found = std::ranges::find(typeNames, word, &TypeName::name);
        if (found == typeNames.end())
            m_text.fail(FileFault::NumberType, word);
        return found->type;
    }

    const FileBytes& m_file;
    TextScanner m_text;
    PlyHeader m_header;
    std::set<std::string_view> m_names; ///< of the elements so far
    bool m_linesEndBackwards;           ///< line ends are \n\r: the last line's second byte does not belong to the body
};
} // namespace

std::uint64_t PlyElement::minSize(PlyEncoding encoding) const
{
    if (encoding == PlyEncoding::Ascii)
        return 2 * properties.size(); // a digit and a blank for each property
    return std::accumulate(
        properties.begin(), properties.end(), std::uint64_t(0),
        [](std::uint64_t sum, const PlyProperty& p) { return sum + sizeOf(p.countType.value_or(p.type)); });
}

const PlyElement* PlyHeader::find(std::string_view name) const
{
    const auto found = std::ranges::find(elements, name, &PlyElement::name);
    return found == elements.end() ? nullptr : &*found;
}

PlyHeader readPlyHeader(const FileBytes& file)
{
    return HeaderReader(file).read();
}
} // namespace core::io
