#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <span>
#include <type_traits>
#include <vector>

namespace core
{
/// Throws std::bad_alloc. From some megabytes on it lies in the system's large pages, where there are any: to touch new
/// memory page by page costs more than to fill it.
std::unique_ptr<std::byte, void (*)(void*)> allocateLarge(std::size_t bytes);

/// Asks for large pages there, as far as they fit in and nothing has touched it yet.
void adviseLargePages(void* memory, std::size_t bytes);

/// As resize(), but what it must allocate is asked for in large pages.
template <typename Element> void resizeInLargePages(std::vector<Element>& elements, std::size_t size)
{
    if (size > elements.capacity()) {
        elements.reserve(std::max(size, 2 * elements.size()));
        adviseLargePages(elements.data() + elements.size(), (elements.capacity() - elements.size()) * sizeof(Element));
    }
    elements.resize(size);
}

/// So many numbers, of any value until they are written.
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
