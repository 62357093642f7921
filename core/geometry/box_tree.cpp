#include "core/geometry/box_tree.h"

#include "core/util/parallel.h"

#include <algorithm>
#include <span>
#include <tuple>

namespace core
{
namespace
{
constexpr std::size_t chunkSize = 1 << 14;

struct Entry
{
    Eigen::Array3f centre; ///< of the box
    Slot box;
};

/// Orders entries so that the boxes of each node are near each other: halves them along the longest side of their
/// centres' box, at a border between children, until each part has at most `most` entries. Calls done(part) for each.
template <typename Done> void divide(std::span<Entry> entries, std::size_t most, Done done)
{
    if (entries.size() <= most)
        return done(entries);
    std::size_t ofChild = 1;
    while (ofChild * BoxTree::nodeSize < entries.size())
        ofChild *= BoxTree::nodeSize;
    FaceBox centres;
    for (const Entry& entry : entries)
        centres.extend(entry.centre);
    Eigen::Index axis = 0;
    (centres.max - centres.min).maxCoeff(&axis);
    const std::size_t middle = chunksOf(entries.size(), ofChild) / 2 * ofChild;
    std::nth_element(entries.begin(), entries.begin() + static_cast<std::ptrdiff_t>(middle), entries.end(),
                     [axis](const Entry& a, const Entry& b) {
                         return std::tie(a.centre[axis], a.box) < std::tie(b.centre[axis], b.box);
                     });
    divide(entries.first(middle), most, done);
    divide(entries.subspan(middle), most, done);
}

/// Returns the boxes in the order of the tree.
std::vector<Entry> inMedianOrder(const std::vector<FaceBox>& boxes)
{
    std::vector<Entry> entries(boxes.size());
    for (std::size_t i = 0; i < boxes.size(); ++i)
        entries[i] = {boxes[i].min / 2 + boxes[i].max / 2, static_cast<Slot>(i)};
    std::vector<std::span<Entry>> parts;
    divide(std::span(entries), chunkSize, [&](std::span<Entry> part) { parts.push_back(part); });
    forEachChunk(parts.size(), 1, [&](std::size_t, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            divide(parts[i], BoxTree::nodeSize,
                   [](std::span<Entry> node) { std::ranges::sort(node, {}, &Entry::box); });
    });
    return entries;
}

std::vector<FaceBox> nodesOver(const std::vector<FaceBox>& below)
{
    std::vector<FaceBox> nodes(chunksOf(below.size(), BoxTree::nodeSize));
    for (std::size_t i = 0; i < below.size(); ++i)
        nodes[i / BoxTree::nodeSize].extend(below[i]);
    return nodes;
}
} // namespace

BoxTree::BoxTree(const std::vector<FaceBox>& boxes)
{
    const std::vector<Entry> entries = inMedianOrder(boxes);
    m_order.resize(entries.size());
    m_levels.emplace_back().resize(entries.size());
    forEachChunk(entries.size(), chunkSize, [&](std::size_t, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            m_order[i] = entries[i].box;
            m_levels[0][i] = boxes[entries[i].box];
        }
    });
    do
        m_levels.push_back(nodesOver(m_levels.back()));
    while (m_levels.back().size() > 1);
}
} // namespace core
