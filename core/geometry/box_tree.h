#pragma once

#include "core/geometry/geometry.h"

#include <vector>

namespace core
{
/// A closed box of float32 numbers, which bounds float32 points and lattice points exactly.
struct FaceBox
{
    Eigen::Array3f min = Eigen::Array3f::Constant(std::numeric_limits<float>::infinity());
    Eigen::Array3f max = Eigen::Array3f::Constant(-std::numeric_limits<float>::infinity());

    void extend(const Eigen::Array3f& p)
    {
        min = min.min(p);
        max = max.max(p);
    }
    void extend(const FaceBox& box)
    {
        min = min.min(box.min);
        max = max.max(box.max);
    }
    bool meets(const FaceBox& other) const
    {
        return (int(min[0] <= other.max[0]) & int(min[1] <= other.max[1]) & int(min[2] <= other.max[2]) &
                int(other.min[0] <= max[0]) & int(other.min[1] <= max[1]) & int(other.min[2] <= max[2])) != 0;
    }
};

/// A static tree of boxes for queries about the whole model. Nodes have eight children and no pointers; the boxes of a
/// node are near each other. The position of a box is its index in the tree's order.
class BoxTree
{
public:
    /// Precondition: no box is empty, and coordinates are finite. Cost: as one sort of the boxes, on all cores.
    explicit BoxTree(const std::vector<FaceBox>& boxes);

    Slot size() const { return static_cast<Slot>(m_order.size()); }
    /// Returns the index in `boxes` of the box at a position.
    Slot at(Slot position) const { return m_order[position]; }
    const FaceBox& box(Slot position) const { return m_levels[0][position]; }

    /// Calls visit(position) for each box that meets the query.
    template <typename Visit> void forEachMeeting(const FaceBox& query, Visit visit) const
    {
        forEachMeetingAt(0, query, 0, visit);
    }

    /// Returns the number of blocks of boxes, for work about all pairs that is divided between cores.
    Slot blocks() const { return static_cast<Slot>(m_levels[blockLevel()].size()); }
    /// Calls visit(i, j) for each pair of positions i < j whose boxes meet and where i is in the block.
    template <typename Visit> void forEachMeetingPair(Slot block, Visit visit) const;

    /// Visits boxes roughly nearest first. reach(box) returns the distance at which the box begins, or infinity to skip
    /// it. visit(position) returns the new bound: boxes from that distance on are skipped. The bound must never grow.
    template <typename Reach, typename Visit> void forEachNear(Reach reach, double bound, Visit visit) const;

    static constexpr Slot nodeSize = 8;
    static constexpr std::size_t maxLevels = 12; // 8^11 exceeds any 32-bit number of faces

private:
    std::size_t blockLevel() const { return std::min<std::size_t>(3, m_levels.size() - 1); }
    /// Calls visit(i) for each entry i >= `from` of the level `target` that meets the query.
    template <typename Visit>
    void forEachMeetingAt(std::size_t target, const FaceBox& query, Slot from, Visit visit) const;
    /// Visits the pairs of boxes below two nodes a <= b of a level. Precondition: the nodes meet.
    template <typename Visit> void visitPairs(std::size_t level, std::size_t a, std::size_t b, Visit& visit) const;

    std::vector<Slot> m_order;
    /// Level 0: the boxes by position; each further level: the nodes over the level below, up to one root.
    std::vector<std::vector<FaceBox>> m_levels;
};

template <typename Visit>
void BoxTree::forEachMeetingAt(std::size_t target, const FaceBox& query, Slot from, Visit visit) const
{
    struct Node
    {
        std::size_t level, index;
    };
    std::array<Node, maxLevels * nodeSize> stack;
    std::size_t depth = 0;
    stack[depth++] = {m_levels.size() - 1, 0};
    while (depth != 0) {
        const auto [level, index] = stack[--depth];
        if (level == target) {
            visit(static_cast<Slot>(index));
            continue;
        }
        const std::vector<FaceBox>& below = m_levels[level - 1];
        const std::size_t first = index * nodeSize, last = std::min(first + nodeSize, below.size());
        // An entry of `below` covers 2^shift entries of the target level
        const std::size_t shift = 3 * (level - 1 - target);
        for (std::size_t i = first; i < last; ++i)
            if (((i + 1) << shift) > from && below[i].meets(query))
                stack[depth++] = {level - 1, i};
    }
}

template <typename Visit> void BoxTree::forEachMeetingPair(Slot block, Visit visit) const
{
    const std::size_t level = blockLevel();
    forEachMeetingAt(level, m_levels[level][block], block, [&](Slot other) { visitPairs(level, block, other, visit); });
}

template <typename Visit> void BoxTree::visitPairs(std::size_t level, std::size_t a, std::size_t b, Visit& visit) const
{
    const std::vector<FaceBox>& below = m_levels[level - 1];
    const FaceBox &boxA = m_levels[level][a], &boxB = m_levels[level][b];
    std::array<std::size_t, nodeSize> meeting; // children of b that meet a
    std::size_t count = 0;
    for (std::size_t j = b * nodeSize; j < std::min((b + 1) * nodeSize, below.size()); ++j)
        if (a == b || below[j].meets(boxA))
            meeting[count++] = j;
    for (std::size_t i = a * nodeSize; i < std::min((a + 1) * nodeSize, below.size()); ++i) {
        if (a != b && !below[i].meets(boxB))
            continue;
        for (std::size_t n = 0; n < count; ++n) {
            const std::size_t j = meeting[n];
            if (j < i || !below[i].meets(below[j]))
                continue;
            if (level > 1)
                visitPairs(level - 1, i, j, visit);
            else if (i != j)
                visit(static_cast<Slot>(i), static_cast<Slot>(j));
        }
    }
}

template <typename Reach, typename Visit> void BoxTree::forEachNear(Reach reach, double bound, Visit visit) const
{
    struct Node
    {
        double reach;
        std::uint32_t level, index;
    };
    std::array<Node, maxLevels * nodeSize> stack;
    std::size_t depth = 0;
    stack[depth++] = {0, static_cast<std::uint32_t>(m_levels.size()) - 1, 0};
    while (depth != 0) {
        const Node node = stack[--depth];
        if (!(node.reach < bound))
            continue;
        const std::vector<FaceBox>& below = m_levels[node.level - 1];
        const auto first = static_cast<std::size_t>(node.index) * nodeSize;
        const std::size_t last = std::min(first + nodeSize, below.size());
        const std::size_t bottom = depth;
        for (std::size_t i = first; i < last; ++i) {
            const double distance = reach(below[i]);
            if (!(distance < bound))
                continue;
            if (node.level == 1) {
                bound = visit(static_cast<Slot>(i));
                continue;
            }
            std::size_t place = depth++; // children are kept sorted, with the nearest on top of the stack
            for (; place > bottom && stack[place - 1].reach < distance; --place)
                stack[place] = stack[place - 1];
            stack[place] = {distance, node.level - 1, static_cast<std::uint32_t>(i)};
        }
    }
}
} // namespace core
