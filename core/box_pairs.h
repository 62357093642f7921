#pragma once

#include "face_octree.h"

#include <algorithm>

namespace core
{
/// Calls visit(i, j), i < j, once for every two boxes that meet and of which the first is one of the first `first`.
/// Few against all: each with each. Else a sweep along x inside strips along y: O(n log n + pairs) for boxes most of which are of
/// similar size.
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
    static constexpr std::size_t fewPairs = 1u << 15;

    struct Entry
    {
        std::int64_t strip;
        int minX;
        Slot box;
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
        const std::int64_t height = stripHeight();
        const std::vector<Entry> entries = sortedEntries(height);
        for (std::size_t a = 0; a < entries.size(); ++a) {
            const LatticeBox& boxA = m_boxes[entries[a].box];
            for (std::size_t b = a + 1; b < entries.size(); ++b) {
                if (entries[b].strip != entries[a].strip || entries[b].minX > boxA.max.x())
                    break;
                const Slot i = std::min(entries[a].box, entries[b].box), j = std::max(entries[a].box, entries[b].box);
                const LatticeBox& boxB = m_boxes[entries[b].box];
                // Of the strips that both lie in, only the first reports the pair.
                if (i < m_first && boxA.meets(boxB) &&
                    stripOf(std::max(boxA.min.y(), boxB.min.y()), height) == entries[a].strip)
                    visit(i, j);
            }
        }
    }

    static std::int64_t stripOf(int y, std::int64_t height) { return (static_cast<std::int64_t>(y) + Lattice::limit) / height; }
    std::int64_t stripHeight() const;
    std::vector<Entry> sortedEntries(std::int64_t height) const;

    std::span<const LatticeBox> m_boxes;
    Slot m_first;
};
} // namespace core
