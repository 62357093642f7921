// Source: the FBX files of many programs; Blender Foundation, "FBX binary file format specification" (code.blender.org,
// 2013). Binary: records of end, number of values, their size (8 bytes each from version 7.5 on, before 4), length of
// the name, name, values, further records up to the end. Text: "Name: value, value {", lines, "}", comments from ";"
// on.
#include "app/import/fbx_records.h"

#include "app/import/fbx_file.h"

#include "core/io/mesh/binary.h"
#include "core/io/mesh/number_parsing.h"

#include <algorithm>
#include <span>

namespace app
{
namespace
{
using Records = std::vector<FbxRecord>;

/// Ends a list of records: no record is so.
struct NotFbx
{};

/// Returns whether the records in that one are wanted, `path` being the names of those around it.
bool isWanted(std::span<const std::string_view> path, std::string_view name)
{
    switch (path.size()) {
    case 0:
        return name == "Definitions" || name == "Objects" || name == "Connections";
    case 1:
        return path[0] == "Objects" ? name == "Model" : path[0] == "Definitions" && name == "ObjectType";
    case 2:
        return path[0] == "Objects" ? name == "Properties70" : name == "PropertyTemplate";
    case 3:
        return path[0] == "Definitions" && name == "Properties70";
    default:
        return false;
    }
}

/// Returns whether a record itself is wanted. Geometry, of which there is most, is not.
bool isKept(std::span<const std::string_view> path, std::string_view name)
{
    return isWanted(path, name) || name == "P" || name == "C";
}

class BinaryReader
{
public:
    explicit BinaryReader(std::string_view bytes) : m_bytes(bytes), m_isWide(fbxVersion(bytes) >= 7500) {}

    Records read()
    {
        constexpr std::size_t headSize = 27;
        m_at = std::min(headSize, m_bytes.size());
        return recordsTo(m_bytes.size());
    }

private:
    std::size_t sizeAt()
    {
        const std::size_t size = m_isWide ? 8 : 4;
        const char* const at = take(size).data();
        return m_isWide ? core::io::load<std::uint64_t>(at, std::endian::little)
                        : core::io::load<std::uint32_t>(at, std::endian::little);
    }
    std::string_view take(std::size_t size)
    {
        if (size > m_bytes.size() - m_at)
            throw NotFbx();
        const std::string_view part = m_bytes.substr(m_at, size);
        m_at += size;
        return part;
    }

    /// Reads records up to a null record or to the byte. Behind the last one of the file there is a footer.
    Records recordsTo(std::size_t end)
    {
        Records records;
        while (m_at < end) {
            const std::size_t begin = m_at, recordEnd = sizeAt();
            if (recordEnd == 0)
                break;
            const std::size_t count = sizeAt(), size = sizeAt();
            const std::string_view name = take(static_cast<unsigned char>(take(1).front()));
            if (recordEnd <= begin || recordEnd > end || size > recordEnd - m_at)
                throw NotFbx();
            const std::size_t inner = m_at + size;
            if (isKept(m_path, name)) {
                records.push_back({name, valuesTo(inner, count), {}});
                m_at = inner;
                if (isWanted(m_path, name)) {
                    m_path.push_back(name);
                    records.back().records = recordsTo(recordEnd);
                    m_path.pop_back();
                }
            }
            m_at = recordEnd;
        }
        return records;
    }

    std::vector<FbxValue> valuesTo(std::size_t end, std::size_t count)
    {
        std::vector<FbxValue> values;
        while (values.size() < count && m_at < end) {
            const char type = take(1).front();
            std::size_t size = sizeOf(type);
            if (type == 'S' || type == 'R')
                size = core::io::load<std::uint32_t>(take(4).data(), std::endian::little);
            if (size == 0 && type != 'S' && type != 'R')
                break; // an array: no record that is wanted has one
            const std::size_t at = m_at;
            values.push_back({type, at, take(size)});
        }
        if (m_at > end)
            throw NotFbx();
        return values;
    }
    static std::size_t sizeOf(char type)
    {
        switch (type) {
        case 'C':
        case 'B':
            return 1;
        case 'Y':
            return 2;
        case 'I':
        case 'F':
            return 4;
        case 'L':
        case 'D':
            return 8;
        default:
            return 0;
        }
    }

    std::string_view m_bytes;
    bool m_isWide;
    std::size_t m_at = 0;
    std::vector<std::string_view> m_path;
};

class TextReader
{
public:
    explicit TextReader(std::string_view bytes) : m_bytes(bytes) {}

    Records read()
    {
        Records records = recordsIn();
        if (m_at < m_bytes.size())
            throw NotFbx(); // a brace too many
        return records;
    }

private:
    bool atEnd() const { return m_at >= m_bytes.size(); }
    char here() const { return m_bytes[m_at]; }
    bool isHere(std::string_view signs) const { return !atEnd() && signs.find(here()) != std::string_view::npos; }

    /// Passes over blanks and comments, and over line ends where those mean nothing.
    void skip(bool overLines)
    {
        while (!atEnd()) {
            if (here() == ';' && overLines)
                m_at = std::min(m_bytes.find('\n', m_at), m_bytes.size());
            else if (here() == ' ' || here() == '\t' || here() == '\r' || (overLines && here() == '\n'))
                ++m_at;
            else
                return;
        }
    }

    /// Reads records up to a closing brace, which is left, or to the file's end.
    Records recordsIn()
    {
        Records records;
        for (skip(true); !atEnd() && here() != '}'; skip(true)) {
            const std::size_t colon = m_bytes.find_first_of(":\n{}\"", m_at);
            if (colon == std::string_view::npos || m_bytes[colon] != ':')
                throw NotFbx();
            const std::string_view name = m_bytes.substr(m_at, colon - m_at);
            m_at = colon + 1;
            const bool keeps = isKept(m_path, name);
            FbxRecord record{name, valuesHere(keeps), {}};
            skip(true);
            if (isHere("{")) {
                ++m_at;
                recordsOf(record);
            }
            if (keeps)
                records.push_back(std::move(record));
        }
        return records;
    }

    /// Reads what is in a record's braces, the first of which has been read.
    void recordsOf(FbxRecord& record)
    {
        if (!isWanted(m_path, record.name))
            return passOver();
        m_path.push_back(record.name);
        record.records = recordsIn();
        m_path.pop_back();
        if (atEnd())
            throw NotFbx();
        ++m_at;
    }

    void passOver()
    {
        for (int depth = 1; depth > 0;) {
            m_at = m_bytes.find_first_of("{}\";", m_at);
            if (m_at >= m_bytes.size())
                throw NotFbx();
            const char sign = m_bytes[m_at++];
            if (sign == '"')
                passTo('"');
            else if (sign == ';')
                passTo('\n');
            else
                depth += sign == '{' ? 1 : -1;
        }
    }
    void passTo(char sign)
    {
        const std::size_t end = m_bytes.find(sign, m_at);
        if (end == std::string_view::npos)
            throw NotFbx();
        m_at = end + 1;
    }

    std::vector<FbxValue> valuesHere(bool keeps)
    {
        std::vector<FbxValue> values;
        for (skip(false); !atEnd() && !isHere("\n{};"); skip(false)) {
            const FbxValue value = valueHere();
            if (keeps)
                values.push_back(value);
            skip(false);
            if (!isHere(","))
                break;
            ++m_at;
            skip(true);
        }
        return values;
    }
    FbxValue valueHere()
    {
        if (here() == '"') {
            const std::size_t begin = ++m_at;
            passTo('"');
            return {'S', begin, m_bytes.substr(begin, m_at - 1 - begin)};
        }
        const std::size_t begin = m_at;
        m_at = std::min(m_bytes.find_first_of(" \t\r\n,{};\"", m_at), m_bytes.size());
        if (m_at == begin)
            throw NotFbx();
        return {'T', begin, m_bytes.substr(begin, m_at - begin)};
    }

    std::string_view m_bytes;
    std::size_t m_at = 0;
    std::vector<std::string_view> m_path;
};
} // namespace

std::optional<double> FbxValue::number() const
{
    switch (type) {
    case 'F':
        return static_cast<double>(core::io::load<float>(bytes.data(), std::endian::little));
    case 'D':
        return core::io::load<double>(bytes.data(), std::endian::little);
    case 'T':
        return core::io::parseDouble(bytes);
    default:
        if (const auto number = whole())
            return static_cast<double>(*number);
        return std::nullopt;
    }
}

std::optional<std::int64_t> FbxValue::whole() const
{
    switch (type) {
    case 'C':
    case 'B':
        return bytes.front();
    case 'Y':
        return core::io::load<std::int16_t>(bytes.data(), std::endian::little);
    case 'I':
        return core::io::load<std::int32_t>(bytes.data(), std::endian::little);
    case 'L':
        return core::io::load<std::int64_t>(bytes.data(), std::endian::little);
    case 'T':
        return core::io::parseInteger(bytes);
    default:
        return std::nullopt;
    }
}

std::optional<Records> fbxModelRecords(std::string_view bytes)
{
    try {
        return isBinaryFbx(bytes) ? BinaryReader(bytes).read() : TextReader(bytes).read();
    } catch (const NotFbx&) {
        return std::nullopt;
    }
}

const FbxRecord* recordIn(const Records& records, std::string_view name)
{
    const auto found = std::ranges::find(records, name, &FbxRecord::name);
    return found == records.end() ? nullptr : &*found;
}
} // namespace app
