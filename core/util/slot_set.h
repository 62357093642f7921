#pragma once

#include "core/util/slot.h"

#include <cstdint>
#include <vector>

namespace core
{
/// A small set of slots from a large range, in the order of adding. Cost: O(1) to query and add, O(set) to clear.
/// Memory: one bit for each slot up to the largest ever added. Slots under a brush are close together, so queries
/// mostly hit the nearest cache.
class SlotSet
{
public:
    void clear()
    {
        for (Slot slot : m_slots)
            m_bits[slot / 64] = 0;
        m_slots.clear();
    }
    /// Returns true if the slot was not in the set.
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
    /// Returns the slots in the order of adding, or ascending after sort().
    const std::vector<Slot>& slots() const { return m_slots; }
    std::size_t size() const { return m_slots.size(); }
    /// Sorts the slots in ascending order. Cost: O(set).
    void sort();

private:
    void grow(Slot slot);

    std::vector<std::uint64_t> m_bits;
    std::vector<Slot> m_slots, m_sorting;
};
} // namespace core
