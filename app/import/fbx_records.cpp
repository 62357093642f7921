// Source: FBX files written by many programs, and Blender Foundation, "FBX binary file format specification"
// (code.blender.org, 2013).
// Binary record: end offset, number of values, size of the values (8 bytes each from version 7.5 on, 4 before), length
// of the name, name, values, nested records up to the end offset.
// Text: "Name: value, value {", lines, "}", comments from ";" to the end of the line.
// If a file deviates from this, it is parsed as Assimp (5.2 to 6.0) parses it.
#include "app/import/fbx_records.h"

#include "app/import/fbx_file.h"

#include "core/io/mesh/binary.h"
#include "core/io/mesh/number_parsing.h"

#include <algorithm>
#include <charconv>
#include <span>
#include <utility>

namespace app
{
namespace
{
using Records = std::vector<FbxRecord>;

/// Thrown if the bytes are not valid records. Assimp does not read such a file either.
struct NotFbx
{};

/// Returns whether the records nested in this record are wanted. `path`: names of the enclosing records.
bool isWanted(std::span<const std::string_view> path, std::string_view name)
{
    switch (path.size()) {
    case 0:
        return name == "GlobalSettings" || name == "Definitions" || name == "Objects" || name == "Connections";
    case 1:
        return path[0] == "Objects"       ? name == "Model" || name == "Geometry"
               : path[0] == "Definitions" ? name == "ObjectType"
                                          : path[0] == "GlobalSettings" && name == "Properties70";
    case 2:
        return path[1] == "Geometry" ? name == "Vertices" || name == "PolygonVertexIndex"
               : path[1] == "Model"  ? name == "Properties70"
                                     : path[0] == "Definitions" && name == "PropertyTemplate";
    case 3:
        return path[0] == "Definitions" && name == "Properties70";
    default:
        return false;
    }
}

/// Returns whether the record contains the numbers of an array in a text file.
bool isArray(std::span<const std::string_view> path, std::string_view name)
{
    return path.size() == 3 && path[1] == "Geometry" && name == "a";
}

/// Returns whether the record itself is wanted. Geometry is most of a file, so only its arrays are kept.
bool isKept(std::span<const std::string_view> path, std::string_view name)
{
    return isWanted(path, name) || name == "P" || name == "C" || isArray(path, name) ||
           (path.size() == 1 && path[0] == "Objects");
}

class BinaryReader
{
public:
    explicit BinaryReader(std::string_view bytes) : m_bytes(bytes), m_isWide(fbxVersion(bytes) >= 7500) {}

    Records read()
    {
        constexpr std::size_t headSize = 27;
        m_at = std::min(headSize, m_bytes.size());
        return recordsTo(m_bytes.size(), true);
    }

    /// Returns the offsets of all type letters "Z" read so far.
    const std::vector<std::size_t>& byteTypes() const { return m_byteTypes; }

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

    /// Reads records up to the offset `end`. At the top level, a null record ends the file, since a footer follows it.
    /// Null records elsewhere are skipped by their end field only, as in Assimp. `keeps`: whether any records are
    /// returned.
    Records recordsTo(std::size_t end, bool keeps)
    {
        constexpr std::size_t maxDepth = 256;
        Records records;
        while (m_at < end) {
            const std::size_t begin = m_at, recordEnd = sizeAt();
            if (recordEnd == 0 && m_path.empty())
                break;
            if (recordEnd == 0)
                continue;
            const std::size_t count = sizeAt(), size = sizeAt();
            const std::string_view name = take(static_cast<unsigned char>(take(1).front()));
            if (recordEnd <= begin || recordEnd > end || size > recordEnd - m_at)
                throw NotFbx();
            const std::size_t inner = m_at + size;
            FbxRecord record{name, valuesTo(inner, count), {}};
            m_at = inner;
            if (inner < recordEnd) {
                const std::size_t nullSize = m_isWide ? 25 : 13; // size of the null record that ends the nested records
                if (recordEnd - inner < nullSize || m_path.size() == maxDepth)
                    throw NotFbx();
                const bool isWithinWanted = keeps && isWanted(m_path, name);
                m_path.push_back(name);
                record.records = recordsTo(recordEnd - nullSize, isWithinWanted);
                m_path.pop_back();
            }
            if (keeps && isKept(m_path, name))
                records.push_back(std::move(record));
            m_at = recordEnd;
        }
        return records;
    }

    std::vector<FbxValue> valuesTo(std::size_t end, std::size_t count)
    {
        std::vector<FbxValue> values;
        while (values.size() < count && m_at < end) {
            const char type = take(1).front();
            if (type == 'Z')
                m_byteTypes.push_back(m_at - 1);
            const std::size_t size = type == 'b' ? end - m_at : sizeOf(type), at = m_at;
            values.push_back({type, at, take(size)});
        }
        if (m_at > end)
            throw NotFbx();
        return values;
    }
    /// Returns the size of a value of this type, bytes. For strings and arrays, reads the size field and returns its
    /// value.
    std::size_t sizeOf(char type)
    {
        constexpr std::size_t arrayHead = 8; // number of elements and encoding, before the size field
        switch (type) {
        case 'C':
        case 'B':
        case 'Z':
            return 1;
        case 'Y':
            return 2;
        case 'I':
        case 'F':
            return 4;
        case 'L':
        case 'D':
            return 8;
        case 'S':
        case 'R':
            return core::io::load<std::uint32_t>(take(4).data(), std::endian::little);
        case 'f':
        case 'd':
        case 'l':
        case 'i':
        case 'c':
            take(arrayHead);
            return core::io::load<std::uint32_t>(take(4).data(), std::endian::little);
        default:
            throw NotFbx();
        }
    }

    std::string_view m_bytes;
    bool m_isWide;
    std::size_t m_at = 0;
    std::vector<std::string_view> m_path;
    std::vector<std::size_t> m_byteTypes;
};

/// A token of FBX text, by Assimp's rules.
struct Token
{
    enum class Type { Key, Data, Comma, Open, Close };
    Type type;
    std::string_view text; ///< for Data including quotes; for Key without the colon
    /// line number where the tokenizer recognised the token's end; LF and CR count as one line each
    std::size_t line = 0;
};

/// Splits FBX text into tokens up to the end of the text or a NUL. Data cut off by the end are dropped. Throws NotFbx.
class TextTokens
{
public:
    explicit TextTokens(std::string_view bytes) : m_bytes(bytes.substr(0, bytes.find('\0'))) {}

    std::optional<Token> next()
    {
        while (!m_waiting && m_at < m_bytes.size()) {
            const std::optional<Token> token = take(m_bytes[m_at]);
            ++m_at;
            if (token)
                return token;
        }
        return std::exchange(m_waiting, std::nullopt);
    }

    /// Skips a block in braces, whose opening brace has been read, and its closing brace.
    void passBraces()
    {
        for (int depth = 1; depth > 0;) {
            const char sign = passTo("{}\";");
            if (sign == '"')
                passTo("\"");
            else if (sign == ';')
                passTo(lineEnds);
            else
                depth += sign == '{' ? 1 : -1;
        }
    }

    /// Returns the offset in the text at which the view begins.
    std::size_t placeOf(std::string_view text) const { return static_cast<std::size_t>(text.data() - m_bytes.data()); }

private:
    static constexpr std::string_view lineEnds = "\n\r\f";

    /// Skips to just after the next character in `signs`, and returns that character.
    char passTo(std::string_view signs)
    {
        m_at = m_bytes.find_first_of(signs, m_at);
        if (m_at == std::string_view::npos)
            throw NotFbx();
        return m_bytes[m_at++];
    }

    /// Processes one character. Returns the token that it ends; if it is a token itself, it is kept in m_waiting.
    std::optional<Token> take(char sign)
    {
        const bool isLineEnd = lineEnds.find(sign) != std::string_view::npos;
        m_line += isLineEnd ? 1 : 0;
        m_isComment = m_isComment && !isLineEnd;
        if (m_isComment)
            return std::nullopt;
        if (m_isQuoted) {
            m_isQuoted = sign != '"';
            return m_isQuoted ? std::nullopt : endData(m_at + 1);
        }
        switch (sign) {
        case '"':
            if (m_begin)
                throw NotFbx();
            m_begin = m_at;
            m_isQuoted = true;
            return std::nullopt;
        case ';':
            m_isComment = true;
            return endData(m_at);
        case '{':
            return endDataBefore(Token::Type::Open);
        case '}':
            return endDataBefore(Token::Type::Close);
        case ',':
            return endDataBefore(Token::Type::Comma);
        case ':':
            if (!m_begin)
                throw NotFbx();
            return endData(m_at, Token::Type::Key);
        case ' ':
        case '\t':
            return endData(m_at);
        default:
            if (isLineEnd)
                return endData(m_at);
            m_begin = m_begin.value_or(m_at);
            return std::nullopt;
        }
    }

    /// Returns the token that has begun, if there is one.
    std::optional<Token> endData(std::size_t end, Token::Type type = Token::Type::Data)
    {
        if (!m_begin)
            return std::nullopt;
        const std::size_t begin = *std::exchange(m_begin, std::nullopt);
        return Token{type, m_bytes.substr(begin, end - begin), m_line};
    }
    std::optional<Token> endDataBefore(Token::Type type)
    {
        const Token sign{type, m_bytes.substr(m_at, 1), m_line};
        std::optional<Token> data = endData(m_at);
        if (!data)
            return sign;
        m_waiting = sign;
        return data;
    }

    std::string_view m_bytes;
    std::size_t m_at = 0, m_line = 0;
    std::optional<std::size_t> m_begin; ///< offset of the first character of the unfinished token
    std::optional<Token> m_waiting;
    bool m_isComment = false, m_isQuoted = false;
};

/// Parses text as Assimp does: a surplus closing brace ends the file, and a value on the next line needs no comma.
class TextReader
{
public:
    explicit TextReader(std::string_view bytes) : m_tokens(bytes) {}

    Records read() { return recordsHere(); }

private:
    using Type = Token::Type;

    void advance() { m_token = m_tokens.next(); }
    Token present() const
    {
        if (!m_token)
            throw NotFbx();
        return *m_token;
    }

    /// Reads records up to a closing brace or, at the top level, the end of the file.
    Records recordsHere()
    {
        Records records;
        advance();
        while (present().type != Type::Close) {
            const Token key = present();
            if (key.type != Type::Key)
                throw NotFbx();
            FbxRecord record{key.text, {}, {}};
            const bool keeps = isKept(m_path, record.name);
            readRecord(record, keeps);
            if (keeps)
                records.push_back(std::move(record));
            if (!m_token && m_path.empty())
                break;
        }
        return records;
    }

    /// Reads a record, whose key is the present token, up to the token after the record.
    void readRecord(FbxRecord& record, bool keeps)
    {
        do {
            advance();
            if (const Token data = present(); data.type == Type::Data) {
                addValue(record, data, keeps);
                advance();
                const Token behind = present();
                if (behind.type == Type::Data && behind.line != data.line + 1)
                    throw NotFbx();
                if (behind.type == Type::Data)
                    addValue(record, behind, keeps);
            }
            if (present().type == Type::Open) {
                readBraces(record);
                return advance();
            }
        } while (present().type != Type::Key && present().type != Type::Close);
    }

    void readBraces(FbxRecord& record)
    {
        if (!isWanted(m_path, record.name))
            return m_tokens.passBraces();
        m_path.push_back(record.name);
        record.records = recordsHere();
        m_path.pop_back();
    }

    void addValue(FbxRecord& record, const Token& token, bool keeps) const
    {
        if (!keeps)
            return;
        const bool isQuoted = token.text.front() == '"';
        if (!isQuoted && isArray(m_path, record.name) && core::io::parseFloat(token.text))
            return;
        const std::string_view text = isQuoted ? token.text.substr(1, token.text.size() - 2) : token.text;
        record.values.push_back({isQuoted ? 'S' : 'T', m_tokens.placeOf(text), text});
    }

    TextTokens m_tokens;
    std::optional<Token> m_token; ///< the present token; empty: end of the text
    std::vector<std::string_view> m_path;
};

std::optional<std::int64_t> wholeIn(std::string_view word)
{
    if (const auto number = core::io::parseInteger(word))
        return number;
    std::uint64_t id = 0;
    const auto [end, problem] = std::from_chars(word.data(), word.data() + word.size(), id);
    if (problem != std::errc() || end != word.data() + word.size())
        return std::nullopt;
    return static_cast<std::int64_t>(id);
}
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
        return wholeIn(bytes);
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

std::vector<std::size_t> fbxByteTypes(std::string_view bytes)
{
    if (!isBinaryFbx(bytes))
        return {};
    BinaryReader reader(bytes);
    try {
        reader.read();
    } catch (const NotFbx&) {
        return {}; // Assimp refuses such a file anyway
    }
    return reader.byteTypes();
}

const FbxRecord* recordIn(const Records& records, std::string_view name)
{
    const auto found = std::ranges::find(records, name, &FbxRecord::name);
    return found == records.end() ? nullptr : &*found;
}
} // namespace app
