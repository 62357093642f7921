#pragma once

#include "core/geometry/geometry.h"

#include <unordered_map>

namespace core
{
/// Half-edges that have no face yet, found by their ends.
class UnpairedHalfedges
{
public:
    /// Removes and returns the unpaired half-edge from -> to; returns noSlot if there is none.
    Slot take(Slot from, Slot to)
    {
        const auto found = m_unpaired.find(key(from, to));
        if (found == m_unpaired.end())
            return noSlot;
        const Slot h = found->second;
        m_unpaired.erase(found);
        return h;
    }
    void add(Slot from, Slot to, Slot h) { m_unpaired.emplace(key(from, to), h); }
    void reserve(std::size_t count) { m_unpaired.reserve(count); }
    bool empty() const { return m_unpaired.empty(); }

private:
    static std::uint64_t key(Slot from, Slot to) { return std::uint64_t(from) << 32 | to; }
    std::unordered_map<std::uint64_t, Slot> m_unpaired;
};
} // namespace core
