#pragma once

#include "core/util/slot.h"

#include <algorithm>
#include <numeric>
#include <vector>

namespace core
{
/// Union-find over [0, count) with path halving. The root of a set is its lowest member.
class DisjointSets
{
public:
    explicit DisjointSets(std::size_t count) : m_parent(count) { std::iota(m_parent.begin(), m_parent.end(), Slot(0)); }

    Slot root(Slot i)
    {
        while (m_parent[i] != i)
            i = m_parent[i] = m_parent[m_parent[i]];
        return i;
    }
    void unite(Slot a, Slot b)
    {
        a = root(a);
        b = root(b);
        m_parent[std::max(a, b)] = std::min(a, b);
    }
    std::size_t size() const { return m_parent.size(); }

private:
    std::vector<Slot> m_parent;
};
} // namespace core
