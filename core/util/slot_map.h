#pragma once

#include "core/util/slot.h"

#include <cstddef>
#include <iterator>
#include <vector>

namespace core
{
/// The allocator of an element array's slots. Its only state is which slots are free: the slot of the next element
/// follows from these and a hint. Restoring elements therefore restores the allocator bit for bit.
class SlotMap
{
public:
    Slot size() const { return m_size; } ///< number of slots in use or free, which is the length of the arrays
    Slot free() const { return m_free; }
    Slot live() const { return m_size - m_free; }
    bool isFree(Slot slot) const { return (m_words[slot / 64] >> (slot % 64)) & 1; }

    /// Takes a free slot: one near `hint` if there is one; else the lowest free slot, if at least an eighth of all
    /// slots is free; else a new slot at the end, which makes size() grow by one.
    Slot take(Slot hint);
    void setFree(Slot slot, bool free);
    /// Grows or shrinks the array. New slots are free.
    void resize(Slot size);
    void reserve(Slot capacity);

private:
    Slot takeFromWord(Slot word);

    std::vector<std::uint64_t> m_words;   ///< 1 bit per slot, 1 = free
    std::vector<std::uint64_t> m_summary; ///< 1 bit per word of m_words, 1 = the word has a free slot
    Slot m_size = 0;
    Slot m_free = 0;
};

/// A range of the slots in use, ascending, which is also its own iterator. Slots appended during the iteration are
/// skipped.
class LiveSlots
{
public:
    using value_type = Slot;
    using difference_type = std::ptrdiff_t;

    explicit LiveSlots(const SlotMap& map) : m_map(&map), m_end(map.size()) { skipFree(); }
    LiveSlots begin() const { return *this; }
    std::default_sentinel_t end() const { return {}; }

    Slot operator*() const { return m_slot; }
    LiveSlots& operator++()
    {
        ++m_slot;
        skipFree();
        return *this;
    }
    void operator++(int) { ++*this; }
    bool operator==(std::default_sentinel_t) const { return m_slot == m_end; }

private:
    void skipFree()
    {
        while (m_slot != m_end && m_map->isFree(m_slot))
            ++m_slot;
    }

    const SlotMap* m_map;
    Slot m_slot = 0, m_end;
};
} // namespace core
