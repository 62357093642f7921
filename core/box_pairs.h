#pragma once

#include "face_octree.h"

#include <algorithm>
#include <functional>

namespace core
{
/// Calls visit(i, j), i < j, once for every two boxes that meet and of which the first is one of the first `first`.
/// Few against all: each with each. Else a sweep along the longest axis of all inside strips along the second longest:
/// O(n log n + pairs) for boxes most of which are of similar size.
class BoxPairs
{
public:
    explicit BoxPairs(std::span<const LatticeBox> boxes, Slot first) : m_boxes(boxes), m_first(first) {}

    template <class Visit> void forEach(Visit visit) const
    {
        if (static_cast<std::size_t>(m_first) * m_boxes.size() <= fewPairs)
            eachWithEach(visit);
        else
            sweep(visit);
    }

private:
    static constexpr std::size_t fewPairs = 1u << 12;

    /// A box in one of its strips, with all that the sweep asks about at hand.
    struct Entry
    {
        int strip;
        Slot box;
        std::array<int, 3> min, max; ///< along the sweep, across the strips, and the third way
    };

    template <class Visit> void eachWithEach(Visit visit) const
    {
        for (Slot i = 0; i < m_first; ++i) {
            for (Slot j = i + 1; j < m_boxes.size(); ++j) {
                if (m_boxes[i].meets(m_boxes[j]))
                    visit(i, j);
            }
        }
    }

    template <class Visit> void sweep(Visit visit) const
    {
        const std::array<int, 3> axes = axesByExtent();
        const int height = stripHeight(axes[1]);
        const std::vector<Entry> entries = sortedEntries(axes, height);
        for (std::size_t a = 0; a < entries.size(); ++a) {
            const Entry& s = entries[a];
            for (std::size_t b = a + 1; b < entries.size(); ++b) {
                const Entry& t = entries[b];
                if (t.strip != s.strip || t.min[0] > s.max[0])
                    break;
                const bool meet = (t.min[1] <= s.max[1]) & (s.min[1] <= t.max[1]) & (t.min[2] <= s.max[2]) &
                                  (s.min[2] <= t.max[2]) & (std::min(s.box, t.box) < m_first);
                // Of the strips that both lie in, only the first reports the pair.
                if (meet && stripOf(std::max(s.min[1], t.min[1]), height) == s.strip)
                    visit(std::min(s.box, t.box), std::max(s.box, t.box));
            }
        }
    }

    static int stripOf(int y, int height) { return (y + Lattice::limit) / height; }
    std::array<int, 3> axesByExtent() const;
    int stripHeight(int axis) const;
    std::vector<Entry> sortedEntries(const std::array<int, 3>& axes, int height) const;

    std::span<const LatticeBox> m_boxes;
    Slot m_first;
};
} // namespace core
