#pragma once

#include "geometry.h"

#include <cstdlib>
#include <memory>
#include <vector>

namespace core
{
/// Where a slot stands in a small list, for a large range of slots: O(1) to ask, to add and to clear (Briggs and Torczon 1993).
class SparseIndex
{
public:
    void clear() { m_slots.clear(); }
    /// Adds the slot if it is new. Returns its position.
    Slot add(Slot slot)
    {
        if (slot >= m_capacity)
            grow(slot);
        if (!contains(slot)) {
            m_position[slot] = static_cast<Slot>(m_slots.size());
            m_slots.push_back(slot);
        }
        return m_position[slot];
    }
    bool contains(Slot slot) const
    {
        return slot < m_capacity && m_position[slot] < m_slots.size() && m_slots[m_position[slot]] == slot;
    }
    /// Its position, or noSlot.
    Slot find(Slot slot) const
    {
        if (slot >= m_capacity)
            return noSlot;
        const Slot position = m_position[slot];
        return position < m_slots.size() && m_slots[position] == slot ? position : noSlot;
    }
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
        void operator()(Slot* memory) const { std::free(memory); }
    };
    /// Never initialised: contains() is right whatever stands there. So a page that no slot falls into is never touched, and
    /// a large range costs nothing until it is used.
    std::unique_ptr<Slot[], Free> m_position;
    Slot m_capacity = 0;
    std::vector<Slot> m_slots, m_sorting;
};
} // namespace core
