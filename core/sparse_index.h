#pragma once

#include "geometry.h"

#include <cstdlib>
#include <memory>
#include <vector>

namespace core
{
/// Where a slot stands in a small list, for a large range of slots: O(1) to ask and to add, O(list) to clear. A bit of its own
/// for each slot: those under a brush lie close together, so that what is asked is mostly in the nearest cache.
class SparseIndex
{
public:
    void clear()
    {
        for (Slot slot : m_slots)
            m_members[slot / 64] = 0;
        m_slots.clear();
    }
    /// Adds the slot if it is new. Returns whether it was.
    bool insert(Slot slot)
    {
        const std::size_t before = m_slots.size();
        add(slot);
        return m_slots.size() > before;
    }
    /// Adds the slot if it is new. Returns its position.
    Slot add(Slot slot)
    {
        if (slot >= m_capacity)
            grow(slot);
        std::uint64_t& word = m_members[slot / 64];
        const std::uint64_t bit = std::uint64_t(1) << (slot % 64);
        if ((word & bit) == 0) {
            word |= bit;
            m_position[slot] = static_cast<Slot>(m_slots.size());
            m_slots.push_back(slot);
        }
        return m_position[slot];
    }
    bool contains(Slot slot) const { return slot < m_capacity && (m_members[slot / 64] >> (slot % 64) & 1) != 0; }
    /// Its position, or noSlot.
    Slot find(Slot slot) const { return contains(slot) ? m_position[slot] : noSlot; }
    /// Precondition: contains(slot).
    Slot position(Slot slot) const { return m_position[slot]; }
    /// In the order of adding.
    const std::vector<Slot>& slots() const { return m_slots; }
    std::size_t size() const { return m_slots.size(); }
    /// Sorts the slots; positions change with them. O(slots).
    void sort();

private:
    void grow(Slot slot);

    struct Free
    {
        void operator()(void* memory) const { std::free(memory); }
    };
    /// By slot. Neither is touched before it is used: a large range costs address space only.
    std::unique_ptr<Slot[], Free> m_position;         ///< of members; of others it has never been set
    std::unique_ptr<std::uint64_t[], Free> m_members; ///< a bit each
    Slot m_capacity = 0;
    std::vector<Slot> m_slots, m_sorting;
};
} // namespace core
