#include "core/util/slot_set.h"

#include <algorithm>
#include <array>
#include <utility>

namespace core
{
namespace
{
/// Smallest number of slots that is sorted by radix; fewer are sorted by comparison.
constexpr std::size_t minForRadixSort = 64;
constexpr int digitBits = 8, digits = 4;
constexpr std::size_t digitValues = std::size_t(1) << digitBits;

std::size_t digit(Slot slot, int d)
{
    return slot >> (d * digitBits) & (digitValues - 1);
}

/// Radix sort by digits, lowest first (Knuth, volume 3, section 5.2.5). Slots under a brush share their high digits,
/// which are then skipped.
void sortByDigits(std::vector<Slot>& slots, std::vector<Slot>& other)
{
    std::array<std::array<Slot, digitValues>, digits> counts = {};
    for (const Slot slot : slots) {
        for (int d = 0; d < digits; ++d)
            ++counts[d][digit(slot, d)];
    }
    other.resize(slots.size());
    for (int d = 0; d < digits; ++d) {
        if (counts[d][digit(slots.front(), d)] == slots.size())
            continue; // all slots have the same digit
        Slot begin = 0;
        for (Slot& count : counts[d])
            begin = std::exchange(count, begin) + begin;
        for (const Slot slot : slots)
            other[counts[d][digit(slot, d)]++] = slot;
        slots.swap(other);
    }
}
} // namespace

void SlotSet::sort()
{
    if (m_slots.size() < minForRadixSort)
        std::ranges::sort(m_slots);
    else
        sortByDigits(m_slots, m_sorting);
}

void SlotSet::grow(Slot slot)
{
    const std::size_t words = slot / 64 + 1;
    m_bits.resize(words + words / 8);
}
} // namespace core
