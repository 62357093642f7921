#include "sparse_index.h"

#include <algorithm>
#include <array>
#include <new>
#include <utility>

namespace core
{
namespace
{
/// 32 MB: as much as malloc always takes from fresh pages, which cost nothing before they are touched. Less could come from what
/// a loader has left behind.
constexpr Slot leastCapacity = 1u << 23;
/// Fewer are sorted by comparing.
constexpr std::size_t leastByDigits = 64;
constexpr int digitBits = 8, digits = 4;
constexpr std::size_t digitValues = std::size_t(1) << digitBits;

std::size_t digit(Slot slot, int d)
{
    return slot >> (d * digitBits) & (digitValues - 1);
}

/// By digits, the lowest first (Knuth, volume 3, section 5.2.5): slots under a brush lie close together and share the high ones.
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
            continue; // all have the same
        Slot begin = 0;
        for (Slot& count : counts[d])
            begin = std::exchange(count, begin) + begin;
        for (const Slot slot : slots)
            other[counts[d][digit(slot, d)]++] = slot;
        slots.swap(other);
    }
}
} // namespace

void SparseIndex::sort()
{
    if (m_slots.size() < leastByDigits)
        std::ranges::sort(m_slots);
    else
        sortByDigits(m_slots, m_sorting);
    for (Slot i = 0; i < m_slots.size(); ++i)
        m_position[m_slots[i]] = i;
}

void SparseIndex::grow(Slot slot)
{
    const Slot capacity = std::max(leastCapacity, 2 * slot);
    std::unique_ptr<Slot[], Free> position(static_cast<Slot*>(std::malloc(capacity * sizeof(Slot))));
    std::unique_ptr<std::uint64_t[], Free> members(static_cast<std::uint64_t*>(std::calloc(capacity / 64 + 1, sizeof(std::uint64_t))));
    if (!position || !members)
        throw std::bad_alloc();
    for (Slot i = 0; i < m_slots.size(); ++i) {
        position[m_slots[i]] = i;
        members[m_slots[i] / 64] |= std::uint64_t(1) << (m_slots[i] % 64);
    }
    m_position = std::move(position);
    m_members = std::move(members);
    m_capacity = capacity;
}
} // namespace core
