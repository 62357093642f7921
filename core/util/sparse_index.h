#pragma once

#include "core/util/slot_set.h"

#include <cstdlib>
#include <memory>

namespace core
{
/// A small set of slots from a large range, with the position of each slot in the set. Costs are those of SlotSet.
class SparseIndex
{
public:
    void clear() { m_set.clear(); }
    /// Adds the slot if it is new. Returns its position.
    Slot add(Slot slot)
    {
        if (slot >= m_capacity)
            grow(slot);
        if (m_set.add(slot))
            m_position[slot] = static_cast<Slot>(m_set.size() - 1);
        return m_position[slot];
    }
    bool contains(Slot slot) const { return m_set.contains(slot); }
    /// Returns the slot's position, or noSlot if it is not in the set.
    Slot find(Slot slot) const { return contains(slot) ? m_position[slot] : noSlot; }
    /// Precondition: contains(slot).
    Slot position(Slot slot) const { return m_position[slot]; }
    /// Returns the slots in the order of adding.
    const std::vector<Slot>& slots() const { return m_set.slots(); }
    std::size_t size() const { return m_set.size(); }

private:
    void grow(Slot slot);

    struct Free
    {
        void operator()(Slot* memory) const { std::free(memory); }
    };
    SlotSet m_set;
    /// Position of each slot, uninitialised except for members of the set. A memory page is not touched before it is
    /// used.
    std::unique_ptr<Slot[], Free> m_position;
    Slot m_capacity = 0;
};
} // namespace core
