#pragma once

#include "core/geometry/lattice_box.h"
#include "core/util/parallel.h"

#include <algorithm>
#include <functional>
#include <span>

namespace core
{
/// Finds the pairs of boxes that meet, each pair once; at least one box of a pair is among the first `first` boxes. If
/// there are few possible pairs, all are tested. Otherwise a sweep runs along the longest axis, in strips along the
/// second longest. Cost: O(n log n + pairs) if most boxes are of similar size.
class BoxPairs
{
public:
    using Pair = std::pair<Slot, Slot>;

    explicit BoxPairs(std::span<const LatticeBox> boxes, Slot first) : m_boxes(boxes), m_first(first) {}

    /// Returns the pairs (i, j) of boxes that meet, where i < j, i < `first` and isWanted(i, j). Uses all cores; the
    /// order of the pairs does not depend on their number.
    template <class Test> std::vector<Pair> those(Test isWanted) const
    {
        if (static_cast<std::size_t>(m_first) * m_boxes.size() <= fewPairs)
            return eachWithEach(isWanted);
        return sweep(isWanted);
    }

private:
    static constexpr std::size_t fewPairs = 1u << 12;
    static constexpr std::size_t entriesPerChunk = 1024; ///< number of entries that a core processes at a time

    /// A box in one of the strips that it overlaps, with its bounds copied for the sweep.
    struct Entry
    {
        int strip;
        Slot box;
        std::array<int, 3> min, max; ///< bounds along the sweep axis, the strip axis and the third axis
    };

    template <class Test> std::vector<Pair> eachWithEach(Test isWanted) const
    {
        std::vector<Pair> pairs;
        for (Slot i = 0; i < m_first; ++i) {
            for (Slot j = i + 1; j < m_boxes.size(); ++j) {
                if (m_boxes[i].meets(m_boxes[j]) && isWanted(i, j))
                    pairs.emplace_back(i, j);
            }
        }
        return pairs;
    }

    template <class Test> std::vector<Pair> sweep(Test isWanted) const
    {
        const std::array<int, 3> axes = axesByExtent();
        const int height = stripHeight(axes[1]);
        const std::vector<Entry> entries = sortedEntries(axes, height);
        return joinChunks<std::vector<Pair>>(
            entries.size(), entriesPerChunk, [&](std::size_t begin, std::size_t end, std::vector<Pair>& pairs) {
                for (std::size_t a = begin; a < end; ++a) {
                    const Entry& s = entries[a];
                    for (std::size_t b = a + 1; b < entries.size(); ++b) {
                        const Entry& t = entries[b];
                        if (t.strip != s.strip || t.min[0] > s.max[0])
                            break;
                        const bool meet = (t.min[1] <= s.max[1]) & (s.min[1] <= t.max[1]) & (t.min[2] <= s.max[2]) &
                                          (s.min[2] <= t.max[2]) & (std::min(s.box, t.box) < m_first);
                        // Two boxes may share several strips: only the first of these reports the pair.
                        if (meet && stripOf(std::max(s.min[1], t.min[1]), height) == s.strip &&
                            isWanted(std::min(s.box, t.box), std::max(s.box, t.box)))
                            pairs.emplace_back(std::min(s.box, t.box), std::max(s.box, t.box));
                    }
                }
            });
    }

    static int stripOf(int y, int height) { return (y + Lattice::limit) / height; }
    std::array<int, 3> axesByExtent() const;
    int stripHeight(int axis) const;
    std::vector<Entry> sortedEntries(const std::array<int, 3>& axes, int height) const;

    std::span<const LatticeBox> m_boxes;
    Slot m_first;
};
} // namespace core
