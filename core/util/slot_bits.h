#pragma once

#include "core/util/slot.h"

#include <vector>

namespace core
{
/// A set of slots that is queried far more often than changed. One bit for each slot up to the largest ever added.
class SlotBits
{
public:
    bool contains(Slot slot) const
    {
        return slot / 64 < m_words.size() && (m_words[slot / 64] >> (slot % 64) & 1) != 0;
    }
    void add(Slot slot)
    {
        if (slot / 64 >= m_words.size())
            m_words.resize(2 * (slot / 64 + 1));
        m_words[slot / 64] |= std::uint64_t(1) << (slot % 64);
    }
    void remove(Slot slot)
    {
        if (slot / 64 < m_words.size())
            m_words[slot / 64] &= ~(std::uint64_t(1) << (slot % 64));
    }

private:
    std::vector<std::uint64_t> m_words;
};
} // namespace core
