#pragma once

#include "core/util/slot.h"

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
} // namespace core
