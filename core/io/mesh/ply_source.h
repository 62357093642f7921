#pragma once

#include "core/io/mesh/binary.h"
#include "core/io/mesh/ply_header.h"
#include "core/io/mesh/text_scanner.h"

#include <cmath>

namespace core::io
{
/// Reads the body of a text PLY file value by value. PlyBinarySource has the same interface.
class PlyTextSource
{
public:
    static constexpr bool hasRows = false;

    PlyTextSource(const FileBytes& file, const PlyHeader& header) : m_file(file), m_text(file, header.body) {}

    std::uint64_t bytesLeft() const { return static_cast<std::uint64_t>(fileEnd() - m_text.position()); }

    /// Moves to the next element's line. Lists may continue on further lines.
    void beginElement()
    {
        while (m_text.atLineEnd())
            if (!m_text.nextLine())
                throw errorAtLine(FileErrorKind::CutOff, m_file, m_text.position());
    }
    void endElement()
    {
        for (; !m_text.atLineEnd(); m_text.word())
            m_hasMore = true;
    }
    /// Returns an error at the next line that has words, or at the end.
    FileError errorAtNext(FileErrorKind kind) const
    {
        TextScanner ahead = m_text;
        while (ahead.atLineEnd() && ahead.nextLine()) {
        }
        return errorAtLine(kind, m_file, ahead.position());
    }
    /// Returns whether any element so far had more values than the header declares.
    bool hasMore() const { return m_hasMore; }

    std::int64_t whole(PlyType) { return m_text.toInteger(m_last = m_text.word()); }
    std::int64_t listed(PlyType) { return m_text.toInteger(m_last = m_text.wordAnywhere()); } ///< an item of a list
    float number(PlyType) { return m_text.toNumber(m_last = m_text.word()); }
    void skip(PlyType, std::uint64_t count)
    {
        for (; count != 0; --count)
            if ((count == 1 ? m_text.word() : m_text.wordAnywhere()).empty())
                m_text.fail(FileFault::Number, {});
    }

    /// Throws an error about the value read last.
    [[noreturn]] void fail(FileErrorKind kind, std::uint64_t expected = 0, std::string_view token = {}) const
    {
        throw withCounts(errorAt(kind, token), expected);
    }
    [[noreturn]] void fail(FileFault fault) const { throw malformed(fault, errorAt({}, {})); }

private:
    FileError errorAt(FileErrorKind kind, std::string_view token) const
    {
        return errorAtLine(kind, m_file, m_last.empty() ? m_text.position() : m_last.data(),
                           token.empty() ? m_last : token);
    }
    const char* fileEnd() const { return m_file.bytes.data() + m_file.bytes.size(); }

    FileBytes m_file;
    TextScanner m_text;
    std::string_view m_last;
    bool m_hasMore = false;
};

class PlyBinarySource
{
public:
    /// Elements without lists, or with lists of equal length, have a fixed size. Each can be located without reading
    /// the preceding ones.
    static constexpr bool hasRows = true;

    PlyBinarySource(const FileBytes& file, const PlyHeader& header)
        : m_file(file)
        , m_order(header.encoding == PlyEncoding::BigEndian ? std::endian::big : std::endian::little)
        , m_at(header.body)
        , m_last(header.body)
        , m_end(file.bytes.data() + file.bytes.size())
    {}

    std::uint64_t bytesLeft() const { return static_cast<std::uint64_t>(m_end - m_at); }
    FileError errorAtNext(FileErrorKind kind) const { return errorAtByte(kind, m_file, m_at); }
    void beginElement() {}
    void endElement() {}
    bool hasMore() const { return false; }

    std::int64_t whole(PlyType type)
    {
        switch (type) {
        case PlyType::Int8:
            return next<std::int8_t>();
        case PlyType::Uint8:
            return next<std::uint8_t>();
        case PlyType::Int16:
            return next<std::int16_t>();
        case PlyType::Uint16:
            return next<std::uint16_t>();
        case PlyType::Int32:
            return next<std::int32_t>();
        case PlyType::Uint32:
            return next<std::uint32_t>();
        case PlyType::Float:
            return toWhole(next<float>());
        case PlyType::Double:
            return toWhole(next<double>());
        }
        return 0;
    }

    std::int64_t listed(PlyType type) { return whole(type); }

    float number(PlyType type)
    {
        const float value = type == PlyType::Float    ? next<float>()
                            : type == PlyType::Double ? static_cast<float>(next<double>())
                                                      : static_cast<float>(whole(type));
        if (!std::isfinite(value))
            fail(FileErrorKind::NotANumber);
        return value;
    }

    void skip(PlyType type, std::uint64_t count)
    {
        if (count > bytesLeft() / sizeOf(type))
            failAtEnd();
        m_at += count * sizeOf(type);
    }

    [[noreturn]] void fail(FileErrorKind kind, std::uint64_t expected = 0, std::string_view token = {}) const
    {
        FileError error = errorAtByte(kind, m_file, m_last);
        error.token = token;
        error.expected = expected;
        throw error;
    }
    [[noreturn]] void fail(FileFault fault) const { throw malformed(fault, errorAtByte({}, m_file, m_last)); }

private:
    template <typename Number> Number next()
    {
        if (bytesLeft() < sizeof(Number))
            failAtEnd();
        m_last = m_at;
        m_at += sizeof(Number);
        return load<Number>(m_last, m_order);
    }

    std::int64_t toWhole(double value) const
    {
        constexpr double largest = 9007199254740992.0; // 2^53
        if (!(std::abs(value) < largest) || value != std::floor(value))
            fail(FileErrorKind::NotANumber);
        return static_cast<std::int64_t>(value);
    }

    [[noreturn]] void failAtEnd() const { throw errorAtByte(FileErrorKind::CutOff, m_file, m_end); }

    FileBytes m_file;
    std::endian m_order;
    const char* m_at;
    const char* m_last;
    const char* m_end;
};
} // namespace core::io
