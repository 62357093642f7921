#include "core/analysis/solid_angles.h"

#include "core/analysis/angle_sum.h"
#include "core/geometry/face_geometry.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace core
{
namespace
{
constexpr std::size_t nodeSize = BoxTree::nodeSize;
constexpr std::size_t nodesPerChunk = 1 << 8;
/// Distance from which a node's faces are approximated by one dipole, in radii of the node.
constexpr double farAway = 3;

/// Adds half of the solid angle of the triangle as seen from p (Van Oosterom and Strackee 1983). The angle is positive
/// if the triangle's normal points away from p.
void addHalfSolidAngle(const std::array<Vec3, 3>& triangle, const Vec3& p, AngleSum& sum)
{
    const Vec3 a = triangle[0] - p, b = triangle[1] - p, c = triangle[2] - p;
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    sum.add(la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb, a.dot(b.cross(c)));
}
} // namespace

SolidAngles::SolidAngles(std::span<const Vec3> points, std::span<const Triangle> triangles)
{
    const BoxTree order(faceBoxes(points, triangles));
    for (Slot position = 0; position < order.size(); ++position) {
        const Slot face = order.at(position);
        const Triangle& t = triangles[face];
        m_faces.push_back(face);
        m_triangles.push_back({points[t[0]], points[t[1]], points[t[2]]});
    }
    for (std::size_t covers = 1; !m_triangles.empty(); covers *= nodeSize) {
        Level level;
        level.nodes.resize(chunksOf(m_triangles.size(), covers));
        forEachChunk(level.nodes.size(), nodesPerChunk, [&](std::size_t, std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i)
                level.nodes[i] = dipoleOf(i * covers, std::min((i + 1) * covers, m_triangles.size()));
        });
        m_levels.push_back(std::move(level));
        if (m_levels.back().nodes.size() == 1)
            break;
    }
}

SolidAngles::Dipole SolidAngles::dipoleOf(std::size_t from, std::size_t to) const
{
    Dipole dipole;
    double area = 0;
    for (std::size_t i = from; i < to; ++i) {
        const auto& [a, b, c] = m_triangles[i];
        const Vec3 moment = 0.5 * (b - a).cross(c - a);
        const double weight = moment.norm();
        dipole.moment += moment;
        dipole.centre += weight * (a + b + c) / 3;
        area += weight;
    }
    if (area > 0)
        dipole.centre /= area;
    else
        dipole.centre = m_triangles[from][0];
    for (std::size_t i = from; i < to; ++i)
        for (const Vec3& corner : m_triangles[i])
            dipole.reach2 = std::max(dipole.reach2, farAway * farAway * (corner - dipole.centre).squaredNorm());
    return dipole;
}

double SolidAngles::at(const Vec3& p, std::span<const Slot> without) const
{
    if (m_levels.empty())
        return 0;
    struct Node
    {
        std::size_t level, index;
    };
    std::array<Node, BoxTree::maxLevels * nodeSize> open; // near nodes whose children are to be visited
    std::size_t depth = 0;
    double ofDipoles = 0;
    AngleSum half;
    const auto visit = [&](std::size_t level, std::size_t index) {
        const Dipole& dipole = m_levels[level].nodes[index];
        const Vec3 way = dipole.centre - p;
        const double distance2 = way.squaredNorm();
        if (distance2 > dipole.reach2)
            ofDipoles += dipole.moment.dot(way) / (distance2 * std::sqrt(distance2));
        else if (level > 0)
            open[depth++] = {level, index};
        else if (!std::ranges::binary_search(without, m_faces[index]))
            addHalfSolidAngle(m_triangles[index], p, half);
    };
    visit(m_levels.size() - 1, 0);
    while (depth > 0) {
        const auto [level, index] = open[--depth];
        const std::size_t first = index * nodeSize;
        for (std::size_t i = first; i < std::min(first + nodeSize, m_levels[level - 1].nodes.size()); ++i)
            visit(level - 1, i);
    }
    return (ofDipoles + 2 * half.value()) / (4 * std::numbers::pi);
}
} // namespace core
