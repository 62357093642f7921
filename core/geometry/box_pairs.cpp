#include "core/geometry/box_pairs.h"

namespace core
{
namespace
{
constexpr int boxesPerStrip = 3; ///< height of a strip, in median box heights
/// Strips are enlarged until a box overlaps at most this number of strips on average.
constexpr std::int64_t entriesPerBox = 4;
constexpr std::size_t heightSamples = 1 << 8; ///< number of boxes sampled for the median height
} // namespace

/// Returns the axes by decreasing extent of all boxes together. Along the axis of least extent, strips would be too few
/// to separate the boxes of a flat patch.
std::array<int, 3> BoxPairs::axesByExtent() const
{
    LatticeBox all;
    for (const LatticeBox& box : m_boxes)
        all.extend(box);
    const LatticePoint extent = all.max - all.min;
    std::array<int, 3> axes = {0, 1, 2};
    std::ranges::stable_sort(axes, std::greater(), [&](int axis) { return extent[axis]; });
    return axes;
}

/// Returns the height of the strips along `axis`, lattice units. The median box sets it, so that a few large boxes do
/// not make the strips too high for many small ones.
int BoxPairs::stripHeight(int axis) const
{
    const auto heightOf = [&](const LatticeBox& box) { return box.max[axis] - box.min[axis] + 1; };
    std::vector<int> heights;
    const std::size_t step = std::max<std::size_t>(1, m_boxes.size() / heightSamples);
    for (std::size_t i = 0; i < m_boxes.size(); i += step)
        heights.push_back(heightOf(m_boxes[i]));
    const auto median = heights.begin() + static_cast<std::ptrdiff_t>(heights.size() / 2);
    std::ranges::nth_element(heights, median);
    int height = std::min(boxesPerStrip * *median, Lattice::limit);
    const auto entries = [&] {
        std::int64_t sum = 0;
        for (const LatticeBox& box : m_boxes)
            sum += heightOf(box) / height + 1;
        return sum;
    };
    while (height < Lattice::limit && entries() > entriesPerBox * static_cast<std::int64_t>(m_boxes.size()))
        height *= 2;
    return height;
}

std::vector<BoxPairs::Entry> BoxPairs::sortedEntries(const std::array<int, 3>& axes, int height) const
{
    struct Key
    {
        std::uint64_t place; ///< strip in the upper 32 bits, then the start of the box along the sweep axis
        Slot box;
    };
    std::vector<Key> keys;
    keys.reserve(2 * m_boxes.size());
    for (Slot i = 0; i < m_boxes.size(); ++i) {
        const auto begin = static_cast<std::uint64_t>(m_boxes[i].min[axes[0]] + Lattice::limit);
        const int last = stripOf(m_boxes[i].max[axes[1]], height);
        for (int strip = stripOf(m_boxes[i].min[axes[1]], height); strip <= last; ++strip)
            keys.push_back({static_cast<std::uint64_t>(strip) << 32 | begin, i});
    }
    std::ranges::sort(keys,
                      [](const Key& a, const Key& b) { return std::tie(a.place, a.box) < std::tie(b.place, b.box); });
    std::vector<Entry> entries;
    entries.reserve(keys.size());
    for (const Key& key : keys) {
        const LatticePoint &min = m_boxes[key.box].min, &max = m_boxes[key.box].max;
        entries.push_back({static_cast<int>(key.place >> 32),
                           key.box,
                           {min[axes[0]], min[axes[1]], min[axes[2]]},
                           {max[axes[0]], max[axes[1]], max[axes[2]]}});
    }
    return entries;
}
} // namespace core
