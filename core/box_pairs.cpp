#include "box_pairs.h"

namespace core
{
namespace
{
constexpr std::int64_t boxesPerStrip = 3; ///< a strip is this many median boxes high
constexpr std::int64_t entriesPerBox = 4; ///< strips grow until boxes lie in no more of them than this on average
} // namespace

/// By the median box: a few large ones among many small ones must not make the strips too high for the small ones.
std::int64_t BoxPairs::stripHeight() const
{
    std::vector<std::int64_t> heights;
    heights.reserve(m_boxes.size());
    for (const LatticeBox& box : m_boxes)
        heights.push_back(box.max.y() - box.min.y() + 1);
    const auto median = heights.begin() + static_cast<std::ptrdiff_t>(heights.size() / 2);
    std::ranges::nth_element(heights, median);
    std::int64_t height = boxesPerStrip * *median;
    const auto entries = [&] {
        std::int64_t sum = 0;
        for (std::int64_t h : heights)
            sum += h / height + 1;
        return sum;
    };
    while (entries() > entriesPerBox * static_cast<std::int64_t>(heights.size()))
        height *= 2;
    return height;
}

std::vector<BoxPairs::Entry> BoxPairs::sortedEntries(std::int64_t height) const
{
    std::vector<Entry> entries;
    entries.reserve(2 * m_boxes.size());
    for (Slot i = 0; i < m_boxes.size(); ++i) {
        const std::int64_t last = stripOf(m_boxes[i].max.y(), height);
        for (std::int64_t strip = stripOf(m_boxes[i].min.y(), height); strip <= last; ++strip)
            entries.push_back({strip, m_boxes[i].min.x(), i});
    }
    std::ranges::sort(entries, [](const Entry& a, const Entry& b) {
        return std::tie(a.strip, a.minX, a.box) < std::tie(b.strip, b.minX, b.box);
    });
    return entries;
}
} // namespace core
