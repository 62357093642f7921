#pragma once

#include "core/util/slot.h"

#include <cstdint>
#include <vector>

namespace core
{
/// A small set out of a large range of slots, in the order of adding: O(1) to ask and to add, O(set) to clear. A bit
/// for each slot up to the largest that was ever in it: those under a brush lie close together, so that what is asked
/// is mostly in the nearest cache.
class SlotSet
{
public:
    void clear()
    {
        for (Slot slot : m_slots)
            m_bits[slot / 64] = 0;
        m_slots.clear();
    }
    /// Returns whether it is new.
    bool add(Slot slot)
    {
        if (slot / 64 >= m_bits.size())
            grow(slot);
        std::uint64_t& word = m_bits[slot / 64];
        const std::uint64_t bit = std::uint64_t(1) << (slot % 64);
        if ((word & bit) != 0)
            return false;
        word |= bit;
        m_slots.push_back(slot);
        return true;
    }
    bool contains(Slot slot) const { return slot / 64 < m_bits.size() && (m_bits[slot / 64] >> (slot % 64) & 1) != 0; }
    /// In the order of adding, or as sort() left them.
    const std::vector<Slot>& slots() const { return m_slots; }
    std::size_t size() const { return m_slots.size(); }
    /// Ascending. O(set).
    void sort();

private:
    void grow(Slot slot);

    std::vector<std::uint64_t> m_bits;
    std::vector<Slot> m_slots, m_sorting;
};
} // namespace core
