#include "core/util/slot_map.h"

#include <bit>
#include <cassert>

namespace core
{
namespace
{
constexpr Slot nearWords = 8; ///< search distance around the hint to either side, in words of 64 slots: 512 slots
}

Slot SlotMap::take(Slot hint)
{
    if (m_free > 0) {
        const Slot words = static_cast<Slot>(m_words.size());
        const Slot home = std::min<Slot>(hint / 64, words - 1);
        for (Slot step = 0; step <= nearWords; ++step) {
            if (home + step < words && m_words[home + step])
                return takeFromWord(home + step);
            if (step <= home && m_words[home - step])
                return takeFromWord(home - step);
        }
        if (m_free >= m_size / 8) {
            for (Slot i = 0; i < m_summary.size(); ++i) {
                if (m_summary[i])
                    return takeFromWord(i * 64 + static_cast<Slot>(std::countr_zero(m_summary[i])));
            }
        }
    }
    const Slot slot = m_size;
    resize(m_size + 1);
    setFree(slot, false);
    return slot;
}

Slot SlotMap::takeFromWord(Slot word)
{
    const Slot slot = word * 64 + static_cast<Slot>(std::countr_zero(m_words[word]));
    setFree(slot, false);
    return slot;
}

void SlotMap::setFree(Slot slot, bool free)
{
    assert(slot < m_size);
    std::uint64_t& word = m_words[slot / 64];
    const std::uint64_t bit = std::uint64_t(1) << (slot % 64);
    if (free == ((word & bit) != 0))
        return;
    word ^= bit;
    m_free = free ? m_free + 1 : m_free - 1;
    const std::uint64_t summaryBit = std::uint64_t(1) << (slot / 64 % 64);
    if (word)
        m_summary[slot / 4096] |= summaryBit;
    else
        m_summary[slot / 4096] &= ~summaryBit;
}

void SlotMap::resize(Slot size)
{
    for (Slot slot = size; slot < m_size; ++slot)
        setFree(slot, false); // slots beyond the new size do not count as free
    if (size < m_size) {
        m_size = size;
        return;
    }
    m_words.resize((size + 63) / 64);
    m_summary.resize((m_words.size() + 63) / 64);
    const Slot before = m_size;
    m_size = size;
    for (Slot slot = before; slot < size; ++slot)
        setFree(slot, true);
}

void SlotMap::reserve(Slot capacity)
{
    m_words.reserve((capacity + 63) / 64);
    m_summary.reserve((capacity + 4095) / 4096);
}
} // namespace core
