#pragma once

#include "core/geometry/geometry.h"

#include <unordered_map>

namespace core
{
/// Half-edges that still wait for their face, by their ends.
class OpenHalfedges
{
public:
    /// The waiting half-edge from -> to, which then waits no more, or noSlot.
    Slot take(Slot from, Slot to)
    {
        const auto waiting = m_waiting.find(key(from, to));
        if (waiting == m_waiting.end())
            return noSlot;
        const Slot h = waiting->second;
        m_waiting.erase(waiting);
        return h;
    }
    void add(Slot from, Slot to, Slot h) { m_waiting.emplace(key(from, to), h); }
    void reserve(std::size_t count) { m_waiting.reserve(count); }
    bool empty() const { return m_waiting.empty(); }

private:
    static std::uint64_t key(Slot from, Slot to) { return std::uint64_t(from) << 32 | to; }
    std::unordered_map<std::uint64_t, Slot> m_waiting;
};
} // namespace core
