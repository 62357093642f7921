#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

namespace core
{
/// Counts items and keeps the smallest `capacity` of them in bounded memory.
template <typename Item> class SmallestK
{
public:
    explicit SmallestK(std::size_t capacity) : m_capacity(capacity) {}

    void add(const Item& item)
    {
        ++m_count;
        keep(item);
    }
    /// Counts items that are not added one by one. The caller must keep() those that may be among the smallest.
    void count(std::uint64_t items) { m_count += items; }
    void keep(const Item& item)
    {
        if (m_capacity == 0)
            return;
        m_items.push_back(item);
        if (m_items.size() / 2 < m_capacity)
            return;
        std::nth_element(m_items.begin(), m_items.begin() + static_cast<std::ptrdiff_t>(m_capacity) - 1, m_items.end());
        m_items.resize(m_capacity);
    }
    void add(const SmallestK& other)
    {
        m_count += other.m_count;
        for (const Item& item : other.m_items)
            keep(item);
    }

    std::size_t capacity() const { return m_capacity; }
    std::uint64_t count() const { return m_count; }
    /// Removes and returns the smallest items, ascending and without duplicates.
    std::vector<Item> take()
    {
        std::sort(m_items.begin(), m_items.end());
        m_items.erase(std::unique(m_items.begin(), m_items.end()), m_items.end());
        m_items.resize(std::min(m_items.size(), m_capacity));
        return std::move(m_items);
    }

private:
    std::size_t m_capacity;
    std::uint64_t m_count = 0;
    std::vector<Item> m_items;
};
} // namespace core
