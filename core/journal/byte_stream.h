#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>

namespace core
{
/// Appends plain values to a string in this machine's byte order and layout: journals are never read on another
/// machine.
class ByteWriter
{
public:
    explicit ByteWriter(std::string& out) : m_out(out) {}

    template <class... Values> void pass(const Values&... values) { (put(values), ...); }

    template <class T> void put(const T& value)
    {
        static_assert(std::is_trivially_copyable_v<T>);
        m_out.append(reinterpret_cast<const char*>(&value), sizeof value);
    }
    void put(std::string_view text)
    {
        put(static_cast<std::uint32_t>(text.size()));
        m_out.append(text);
    }
    void put(const std::string& text) { put(std::string_view(text)); }

private:
    std::string& m_out;
};

/// Reads values in the order in which ByteWriter wrote them. Past the end of the bytes it returns zeros and isGood() is
/// false.
class ByteReader
{
public:
    explicit ByteReader(std::string_view bytes) : m_rest(bytes) {}

    template <class... Values> void pass(Values&... values) { (take(values), ...); }

    template <class T> void take(T& value) { value = take<T>(); }
    void take(bool& value) { value = take<std::uint8_t>() != 0; }
    void take(std::string& text) { text = takeText(); }
    template <class T> T take()
    {
        static_assert(std::is_trivially_copyable_v<T>);
        T value{};
        if (need(sizeof value)) {
            std::memcpy(static_cast<void*>(&value), m_rest.data(), sizeof value);
            m_rest.remove_prefix(sizeof value);
        }
        return value;
    }
    std::string_view takeText()
    {
        const std::size_t size = take<std::uint32_t>();
        if (!need(size))
            return {};
        const std::string_view text = m_rest.substr(0, size);
        m_rest.remove_prefix(size);
        return text;
    }
    /// Returns the number of elements that follow, given the least size of one element in bytes. Returns 0 if the
    /// remaining bytes are too few.
    std::size_t takeCount(std::size_t bytesEach)
    {
        const std::size_t count = take<std::uint32_t>();
        return need(0) && count <= m_rest.size() / bytesEach ? count : (m_isGood = false, 0);
    }

    bool isGood() const { return m_isGood; }
    bool atEnd() const { return m_isGood && m_rest.empty(); }

private:
    bool need(std::size_t bytes)
    {
        m_isGood = m_isGood && bytes <= m_rest.size();
        return m_isGood;
    }

    std::string_view m_rest;
    bool m_isGood = true;
};
} // namespace core
