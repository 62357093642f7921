#pragma once

#include "core/sculpt/select/region.h"
#include "core/util/sparse_index.h"

#include <limits>

namespace core
{
/// Records the mesh before a stroke moved it: for each vertex, the length of its shortest edge, in mm, and whether the
/// surface was sharp there. A stroke that keeps detail (keepsDetail()) compares these with the current lengths.
class RestLengths
{
public:
    /// Rest length of a vertex that the stroke has created or not yet measured.
    static constexpr double none = std::numeric_limits<double>::infinity();

    void clear();
    /// Records the region's vertices that are not recorded yet. Precondition: the stroke has not moved them. Cost:
    /// O(region).
    void measure(const Region& region, const Mesh& mesh);
    /// Records that the stroke has created this vertex. Its slot may be that of a vertex which the stroke has removed.
    void noteNew(Slot v) { set(v, none, false); }
    /// Returns whether the surface was sharp at v (isSharp()) before the stroke moved it.
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
    std::vector<double> m_lengths; ///< rest lengths, mm, by position in m_vertices
    std::vector<bool> m_sharp;     ///< wasSharp(), by position in m_vertices
};
} // namespace core
