#pragma once

#include "geometry.h"

#include <vector>

namespace core
{
/// Closed, of float32 numbers: holds boxes of float32 points and of lattice points exactly.
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

/// A still tree of boxes, for whole-model questions: boxes in Morton order of their centres, eight to a node, no pointers.
/// A box's position is its place in that order.
class BoxTree
{
public:
    /// Cost: a sort.
    explicit BoxTree(const std::vector<FaceBox>& boxes);

    Slot size() const { return static_cast<Slot>(m_order.size()); }
    /// The index in `boxes` of the box at a position.
    Slot at(Slot position) const { return m_order[position]; }
    const FaceBox& box(Slot position) const { return m_levels[0][position]; }
    const FaceBox& nodeBox(Slot node) const { return m_levels[1][node]; }

    static constexpr Slot nodeSize = 8;
    Slot nodes() const { return static_cast<Slot>(m_levels[1].size()); }

    /// Calls visit(position) for each box from position `from` on that meets the query.
    template <typename Visit> void forEachMeeting(const FaceBox& query, Slot from, Visit visit) const;

    /// Nearest first, about: reach(box) says how far away the box begins, infinity if it is not wanted; visit(position) returns the
    /// distance from which on nothing is wanted any more, never more than `bound` or what it returned before.
    template <typename Reach, typename Visit> void forEachNear(Reach reach, double bound, Visit visit) const;

private:
    static constexpr std::size_t maxLevels = 12; // 8^11 exceeds any number of faces
    std::vector<Slot> m_order;
    std::vector<std::vector<FaceBox>> m_levels; ///< boxes by position, then of nodes, and so on up to one
};

template <typename Visit> void BoxTree::forEachMeeting(const FaceBox& query, Slot from, Visit visit) const
{
    struct Node
    {
        std::uint32_t level, index;
    };
    std::array<Node, maxLevels * nodeSize> stack;
    std::size_t depth = 0;
    stack[depth++] = {static_cast<std::uint32_t>(m_levels.size()) - 1, 0};
    while (depth != 0) {
        const auto [level, index] = stack[--depth];
        const std::vector<FaceBox>& below = m_levels[level - 1];
        const auto first = static_cast<std::size_t>(index) * nodeSize;
        const std::size_t last = std::min(first + nodeSize, below.size());
        const unsigned shift = 3 * (level - 1); // a box there covers 8^(level - 1) positions
        for (std::size_t i = first; i < last; ++i) {
            if (((i + 1) << shift) <= from || !below[i].meets(query))
                continue;
            if (level == 1)
                visit(static_cast<Slot>(i));
            else
                stack[depth++] = {level - 1, static_cast<std::uint32_t>(i)};
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
            std::size_t place = depth++; // the nearest on top
            for (; place > bottom && stack[place - 1].reach < distance; --place)
                stack[place] = stack[place - 1];
            stack[place] = {distance, node.level - 1, static_cast<std::uint32_t>(i)};
        }
    }
}
} // namespace core
