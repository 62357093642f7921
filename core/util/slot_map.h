#pragma once

#include "core/util/slot.h"

#include <cstddef>
#include <iterator>
#include <vector>

namespace core
{
/// Which slots of an element array are free. The state is nothing but that: where the next element goes follows from
/// the free slots and a hint alone, so restoring elements restores the allocator, bit for bit.
class SlotMap
{
public:
    Slot size() const { return m_size; } ///< slots in use or free; the arrays have this length
    Slot free() const { return m_free; }
    Slot live() const { return m_size - m_free; }
    bool isFree(Slot slot) const { return (m_words[slot / 64] >> (slot % 64)) & 1; }

    /// A free slot near `hint`; failing that, when an eighth of all slots is free, the lowest of them; else a new one
    /// at the end (then size() has grown by one).
    Slot take(Slot hint);
    void setFree(Slot slot, bool free);
    /// New slots are free.
    void resize(Slot size);
    void reserve(Slot capacity);

private:
    Slot takeFromWord(Slot word);

    std::vector<std::uint64_t> m_words;   ///< a bit a slot, 1 = free
    std::vector<std::uint64_t> m_summary; ///< a bit a word, 1 = has a free slot
    Slot m_size = 0;
    Slot m_free = 0;
};

/// The slots in use, ascending: a range, and its own iterator. Slots that are appended meanwhile are left out.
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
