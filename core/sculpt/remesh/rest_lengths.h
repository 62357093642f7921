#pragma once

#include "core/sculpt/select/region.h"
#include "core/util/sparse_index.h"

#include <limits>

namespace core
{
/// The lengths of edges before a stroke moved them: the shortest one at each vertex, in mm, and where the surface was
/// sharp. A stroke that keeps detail (keepsDetail) compares with that what it has squeezed.
class RestLengths
{
public:
    /// Length of an edge at a vertex that the stroke has made, or has not come to yet.
    static constexpr double none = std::numeric_limits<double>::infinity();

    void clear();
    /// Measures the vertices of the region that are not known yet. Precondition: the stroke has not moved them. Cost:
    /// O(region).
    void measure(const Region& region, const Mesh& mesh);
    /// Notes that the stroke has made this vertex, maybe in the slot of one that it has removed.
    void noteNew(Slot v) { set(v, none, false); }
    /// Whether the surface was sharp at v (isSharp()) before the stroke moved it.
    bool wasSharp(Slot v) const
    {
        const Slot i = m_vertices.find(v);
        return i != noSlot && m_sharp[i];
    }

    double of(Slot v) const
    {
        const Slot i = m_vertices.find(v);
        return i == noSlot ? none : m_lengths[i];
    }

private:
    void set(Slot v, double length, bool isSharp);

    SparseIndex m_vertices;
    std::vector<double> m_lengths; ///< by position among them
    std::vector<bool> m_sharp;     ///< likewise
};
} // namespace core
