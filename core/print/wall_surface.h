#pragma once

#include "core/geometry/box_tree.h"
#include "core/geometry/triangle_mesh.h"
#include "core/print/wall_edges.h"
#include "core/print/wall_tree.h"

#include <algorithm>
#include <cmath>

namespace core
{
/// Diameter if no opposite face is found.
constexpr double noBall = std::numeric_limits<double>::infinity();

/// The surface of a solid, seen from within. Faces are addressed by their positions in the tree, so that neighbouring
/// faces use the same boxes.
class WallSurface
{
public:
    explicit WallSurface(const TriangleMesh& mesh);

    std::size_t size() const { return m_walls.size(); }
    /// Returns whether there are so many faces that each may be measured less accurately, because its neighbours
    /// compensate.
    bool hasMany() const { return size() > 100'000; }
    Slot faceAt(Slot position) const { return m_walls[position].face; }
    bool hasArea(Slot position) const { return !m_walls[position].normal.isZero(); }
    double areaOf(Slot position) const;
    std::array<Vec3, 3> cornersOf(Slot position) const;
    Vec3 pointOf(Slot position, const Vec3& weights) const;

    Vec3 inwardOf(Slot position) const { return -m_walls[position].normal.cast<double>(); }
    bool areOpposite(Slot a, Slot b) const;
    /// Returns whether a ball at one face may touch the other face, or an edge or corner of it.
    bool mayTouch(Slot position, Slot other) const;
    /// Returns a lower bound of the squared distance from the face to the point, or to any point between the points.
    template <std::size_t Count> double reach(Slot position, const std::array<Vec3, Count>& points) const;
    /// Returns whether a ray may leave the matter through a face before the parameter `farthest`, in multiples of the
    /// direction. `length`: length of the direction. Quickly rejects faces that the ray misses although it meets
    /// their boxes, such as long thin faces.
    bool mayLeave(Slot position, const Ray& ray, double length, double farthest) const;

    const WallTree& tree() const { return m_tree; }
    const WallEdges& edges() const { return m_edges; }

private:
    /// A face, stored at its position in the tree.
    struct Wall
    {
        std::array<Vec3f, 3> corners;
        Vec3f normal;      ///< unit length, or zero
        Vec3f across;      ///< unit vector in the face, across its longest side
        float least, most; ///< extent of the face along `across`, measured from the first corner
        Slot face;
        bool isAtEdge = false; ///< result of WallEdges::isAt() for the face
    };

    WallSurface(const TriangleMesh& mesh, const BoxTree& tree);
    static Wall wallOf(const TriangleMesh& mesh, Slot face);
    std::vector<Wall> wallsOf(const TriangleMesh& mesh, const BoxTree& tree) const;
    std::vector<FaceBox> normalsOf(const TriangleMesh& mesh) const;

    WallEdges m_edges;
    std::vector<Wall> m_walls; ///< faces by position in the tree
    WallTree m_tree;
};

inline bool WallSurface::areOpposite(Slot a, Slot b) const
{
    return static_cast<double>(m_walls[a].normal.dot(m_walls[b].normal)) < maxOppositeCosine;
}

inline bool WallSurface::mayTouch(Slot position, Slot other) const
{
    return areOpposite(position, other) || m_walls[other].isAtEdge;
}

/// Bounds the distance by the face's plane and by its extent across its longest side.
template <std::size_t Count> double WallSurface::reach(Slot position, const std::array<Vec3, Count>& points) const
{
    constexpr double error = 1e-6, infinity = std::numeric_limits<double>::infinity();
    const Wall& wall = m_walls[position];
    const Vec3 corner = wall.corners[0].cast<double>(), normal = wall.normal.cast<double>(),
               across = wall.across.cast<double>();
    double lowest = infinity, highest = -infinity, first = infinity, last = -infinity, off = 0;
    for (const Vec3& p : points) {
        const Vec3 way = p - corner;
        const double height = way.dot(normal), aside = way.dot(across);
        off = std::max(off, error * way.lpNorm<1>());
        lowest = std::min(lowest, height);
        highest = std::max(highest, height);
        first = std::min(first, aside);
        last = std::max(last, aside);
    }
    const double up = std::max({0.0, lowest - off, -highest - off});
    const double beside =
        std::max({0.0, static_cast<double>(wall.least) - last - off, first - static_cast<double>(wall.most) - off});
    return up * up + beside * beside;
}

inline bool WallSurface::mayLeave(Slot position, const Ray& ray, double length, double farthest) const
{
    constexpr double error = 1e-6, grazing = 0.01, errorThen = 4 * error / grazing;
    const Wall& wall = m_walls[position];
    const Vec3 normal = wall.normal.cast<double>(), way = ray.origin - wall.corners[0].cast<double>();
    const double slope = ray.direction.dot(normal);
    if (slope < grazing * length)
        return slope >= -error * length;
    const double distance = -way.dot(normal) / slope, off = errorThen * way.lpNorm<1>();
    if (distance * length < -off || (distance - farthest) * length > off)
        return false;
    const double aside = (way + distance * ray.direction).dot(wall.across.cast<double>());
    return aside >= static_cast<double>(wall.least) - off && aside <= static_cast<double>(wall.most) + off;
}
} // namespace core
