// Builds the paper's sphere: each triangle of an icosahedron is split in four, and new vertices are moved out to the
// sphere. Uses only + - x / sqrt, so that every machine gets the same bits.

#include "core/geometry/triangle_mesh.h"

#include <cassert>
#include <cmath>
#include <unordered_map>

namespace core
{
namespace
{
constexpr std::array<Triangle, 20> icosahedronFaces{{
    {0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
    {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
    {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1},
}};

std::vector<Vec3> icosahedronPoints()
{
    const double phi = (1 + std::sqrt(5.0)) / 2;
    return {{-1, phi, 0},  {1, phi, 0},  {-1, -phi, 0}, {1, -phi, 0}, {0, -1, phi},  {0, 1, phi},
            {0, -1, -phi}, {0, 1, -phi}, {phi, 0, -1},  {phi, 0, 1},  {-phi, 0, -1}, {-phi, 0, 1}};
}

Vec3 toUnitLength(const Vec3& p)
{
    return p / std::sqrt(p.x() * p.x() + p.y() * p.y() + p.z() * p.z());
}

class Subdivision
{
public:
    explicit Subdivision(std::vector<Vec3>& points) : m_points(points) {}

    std::vector<Triangle> split(const std::vector<Triangle>& triangles)
    {
        m_midpoints.clear();
        m_midpoints.reserve(triangles.size() * 3 / 2);
        std::vector<Triangle> result;
        result.reserve(4 * triangles.size());
        for (const auto& [a, b, c] : triangles) {
            const Slot ab = midpoint(a, b), bc = midpoint(b, c), ca = midpoint(c, a);
            result.insert(result.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
        }
        return result;
    }

private:
    Slot midpoint(Slot a, Slot b)
    {
        const std::uint64_t edge = std::uint64_t(std::min(a, b)) << 32 | std::max(a, b);
        const auto [entry, isNew] = m_midpoints.try_emplace(edge, static_cast<Slot>(m_points.size()));
        if (isNew)
            m_points.push_back(toUnitLength(m_points[a] + m_points[b]));
        return entry->second;
    }

    std::vector<Vec3>& m_points;
    std::unordered_map<std::uint64_t, Slot> m_midpoints;
};
} // namespace

TriangleMesh icosphere(int subdivisions, double radius)
{
    assert(subdivisions >= 0 && subdivisions <= 12 && radius > 0);
    std::vector<Vec3> points = icosahedronPoints();
    for (Vec3& p : points)
        p = toUnitLength(p);
    TriangleMesh mesh;
    mesh.triangles.assign(icosahedronFaces.begin(), icosahedronFaces.end());
    Subdivision subdivision(points);
    for (int i = 0; i < subdivisions; ++i)
        mesh.triangles = subdivision.split(mesh.triangles);
    mesh.points.reserve(points.size());
    for (const Vec3& p : points)
        mesh.points.push_back((radius * p).cast<float>());
    return mesh;
}
} // namespace core
