#include "core/geometry/box_tree.h"

#include "core/geometry/morton_code.h"
#include "core/util/parallel.h"
#include "core/util/radix_sort.h"

namespace core
{
namespace
{
constexpr std::size_t chunkSize = 1 << 14;

struct Key
{
    std::uint64_t code;
    Slot box;
};

std::vector<Key> mortonKeys(const std::vector<FaceBox>& boxes)
{
    FaceBox all;
    for (const FaceBox& box : boxes)
        all.extend(box);
    const Eigen::Array3d origin = all.min.cast<double>();
    const double side = (all.max.cast<double>() - origin).maxCoeff();
    const double scale = side > 0 ? ((1 << mortonBits) - 1) / side : 0;
    std::vector<Key> keys(boxes.size());
    forEachChunk(boxes.size(), chunkSize, [&](std::size_t, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const Eigen::Array3d centre = (boxes[i].min.cast<double>() + boxes[i].max.cast<double>()) / 2;
            const Eigen::Array<std::uint64_t, 3, 1> cell = ((centre - origin) * scale).cast<std::uint64_t>();
            keys[i] = {mortonCode({cell[0], cell[1], cell[2]}), static_cast<Slot>(i)};
        }
    });
    return keys;
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
    std::vector<Key> keys = mortonKeys(boxes);
    radixSort(keys, &Key::code);
    m_order.resize(keys.size());
    m_levels.emplace_back().resize(keys.size());
    forEachChunk(keys.size(), chunkSize, [&](std::size_t, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            m_order[i] = keys[i].box;
            m_levels[0][i] = boxes[keys[i].box];
        }
    });
    do
        m_levels.push_back(nodesOver(m_levels.back()));
    while (m_levels.back().size() > 1);
}
} // namespace core
