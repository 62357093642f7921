#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <span>
#include <type_traits>
#include <vector>

namespace core
{
/// Allocates memory, in large pages of the system where possible and `bytes` is at least 4 MiB. Touching new memory
/// page by page costs more than filling it. Throws std::bad_alloc.
std::unique_ptr<std::byte, void (*)(void*)> allocateLarge(std::size_t bytes);

/// Asks the system for large pages in memory that has not been touched yet. No effect below 4 MiB or where unsupported.
void adviseLargePages(void* memory, std::size_t bytes);

/// Resizes as std::vector::resize(), but asks for large pages for memory that it must allocate.
template <typename Element> void resizeInLargePages(std::vector<Element>& elements, std::size_t size)
{
    if (size > elements.capacity()) {
        elements.reserve(std::max(size, 2 * elements.size()));
        adviseLargePages(elements.data() + elements.size(), (elements.capacity() - elements.size()) * sizeof(Element));
    }
    elements.resize(size);
}

/// A fixed-size array of numbers, not initialised, in large pages where possible.
template <typename Number> class LargeBuffer
{
    static_assert(std::is_trivially_copyable_v<Number> && std::is_trivially_destructible_v<Number>);

public:
    explicit LargeBuffer(std::size_t size) : m_bytes(allocateLarge(size * sizeof(Number))), m_size(size) {}

    std::size_t size() const { return m_size; }
    Number* data() { return reinterpret_cast<Number*>(m_bytes.get()); }
    const Number* data() const { return reinterpret_cast<const Number*>(m_bytes.get()); }
    Number& operator[](std::size_t i) { return data()[i]; }
    const Number& operator[](std::size_t i) const { return data()[i]; }
    std::span<Number> part(std::size_t begin, std::size_t end) { return {data() + begin, end - begin}; }

private:
    std::unique_ptr<std::byte, void (*)(void*)> m_bytes;
    std::size_t m_size;
};
} // namespace core
