#pragma once

#include "core/util/slot_set.h"

#include <cstdlib>
#include <memory>

namespace core
{
/// A small set out of a large range of slots that knows where each stands in it. Costs are those of SlotSet.
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
    /// Its position, or noSlot.
    Slot find(Slot slot) const { return contains(slot) ? m_position[slot] : noSlot; }
    /// Precondition: contains(slot).
    Slot position(Slot slot) const { return m_position[slot]; }
    /// In the order of adding.
    const std::vector<Slot>& slots() const { return m_set.slots(); }
    std::size_t size() const { return m_set.size(); }

private:
    void grow(Slot slot);

    struct Free
    {
        void operator()(Slot* memory) const { std::free(memory); }
    };
    SlotSet m_set;
    /// Never initialised, and only that of members is read: no page is touched before it is used.
    std::unique_ptr<Slot[], Free> m_position;
    Slot m_capacity = 0;
};
} // namespace core
