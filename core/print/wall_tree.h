#pragma once

#include "core/geometry/box_tree.h"

namespace core
{
/// A BoxTree whose nodes store the eight boxes below them as float32 arrays, so that they are tested together. Each box
/// has another box that bounds the normals of what is in it. Tests are conservative: they accept every box that a test
/// in doubles would accept.
class WallTree
{
public:
    static constexpr std::size_t width = BoxTree::nodeSize;
    using Floats = Eigen::Array<float, static_cast<int>(width), 1>;
    struct Node
    {
        std::array<Floats, 3> min, max;
        std::array<Floats, 3> minNormal, maxNormal;
    };

    /// Keeps the positions of the boxes. `normals`: bounds of the normals, by position.
    WallTree(const BoxTree& tree, std::vector<FaceBox> normals);

    /// Computes where a ray enters boxes, in multiples of its direction (slab test, Kay and Kajiya 1986).
    class Ray
    {
    public:
        Ray(const WallTree& tree, const Vec3& origin, const Vec3& direction);
        Floats operator()(const Node& node) const;

    private:
        std::array<float, 3> m_afterOrigin, m_beforeOrigin, m_inverse;
    };
    /// Computes the squared distances of boxes from a point.
    class Point
    {
    public:
        Point(const WallTree& tree, const Vec3& p);
        Floats operator()(const Node& node) const;

    private:
        std::array<float, 3> m_after, m_before;
    };

    /// Tells which boxes have a normal at more than a given angle from a direction, so that it may be opposite.
    class Opposite
    {
    public:
        Opposite(const Vec3& direction, double maxCosine);
        /// Returns `distances` with infinity for the boxes without such a normal.
        Floats operator()(const Node& node, const Floats& distances) const;

    private:
        std::array<float, 3> m_direction;
        float m_maxCosine;
    };

    /// Visits faces, roughly nearest first. reach(node) returns the distance at which each of the node's boxes begins,
    /// or infinity to skip it. visit(position) returns the new bound: boxes from that distance on are skipped. The
    /// bound must never grow.
    template <typename Reach, typename Visit> void forEachNear(const Reach& reach, double bound, Visit visit) const;

    /// Returns the largest float32 error of a box test with a point of these coordinates.
    double errorOf(const Vec3& p) const;

private:
    static constexpr std::size_t maxLevels = 12; // 8^11 exceeds any 32-bit number of faces

    std::vector<std::vector<Node>> m_levels; ///< nodes above the boxes, level by level, up to one root
    double m_farthest = 0;                   ///< largest absolute coordinate
};

template <typename Reach, typename Visit>
void WallTree::forEachNear(const Reach& reach, double bound, Visit visit) const
{
    struct Entry
    {
        double reach;
        std::uint32_t level, index;
    };
    std::array<Entry, maxLevels * width> stack;
    std::size_t depth = 0;
    stack[depth++] = {0, static_cast<std::uint32_t>(m_levels.size()) - 1, 0};
    while (depth != 0) {
        const Entry entry = stack[--depth];
        if (!(entry.reach < bound))
            continue;
        const Floats distances = reach(m_levels[entry.level][entry.index]);
        const std::uint32_t first = entry.index * static_cast<std::uint32_t>(width);
        const std::size_t bottom = depth;
        for (std::uint32_t i = 0; i < width; ++i) {
            const auto distance = static_cast<double>(distances[i]);
            if (!(distance < bound))
                continue;
            if (entry.level == 0) {
                bound = visit(static_cast<Slot>(first + i));
                continue;
            }
            std::size_t place = depth++; // children are kept sorted, with the nearest on top of the stack
            for (; place > bottom && stack[place - 1].reach < distance; --place)
                stack[place] = stack[place - 1];
            stack[place] = {distance, entry.level - 1, first + i};
        }
    }
}

inline WallTree::Floats WallTree::Ray::operator()(const Node& node) const
{
    constexpr float closer = 1 - 5e-7F, farther = 1 + 5e-7F, infinity = std::numeric_limits<float>::infinity();
    Floats enter = Floats::Zero(), leave = Floats::Constant(infinity);
    for (std::size_t i = 0; i < 3; ++i) {
        const Floats low = (node.min[i] - m_afterOrigin[i]) * m_inverse[i];
        const Floats high = (node.max[i] - m_beforeOrigin[i]) * m_inverse[i];
        const bool isForward = m_inverse[i] > 0;
        enter = enter.max(isForward ? low : high);
        leave = leave.min(isForward ? high : low);
    }
    return (enter <= leave * farther).select(enter * closer, Floats::Constant(infinity));
}

/// Uses the least scalar product of the direction with a vector in the box of normals.
inline WallTree::Floats WallTree::Opposite::operator()(const Node& node, const Floats& distances) const
{
    Floats least = Floats::Zero();
    for (std::size_t i = 0; i < 3; ++i)
        least += m_direction[i] * (m_direction[i] > 0 ? node.minNormal[i] : node.maxNormal[i]);
    return (least < m_maxCosine).select(distances, Floats::Constant(std::numeric_limits<float>::infinity()));
}

inline WallTree::Floats WallTree::Point::operator()(const Node& node) const
{
    constexpr float closer = 1 - 1e-6F;
    Floats sum = Floats::Zero();
    for (std::size_t i = 0; i < 3; ++i)
        sum += (node.min[i] - m_after[i]).max(m_before[i] - node.max[i]).max(0.0F).square();
    return sum * closer;
}
} // namespace core
