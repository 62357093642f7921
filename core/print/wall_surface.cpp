#include "core/print/wall_surface.h"

#include "core/geometry/face_geometry.h"

#include <algorithm>
#include <cmath>

namespace core
{
namespace
{
constexpr std::size_t facesAtOnce = 256;
} // namespace

WallSurface::WallSurface(const TriangleMesh& mesh) : WallSurface(mesh, BoxTree(faceBoxes(mesh.points, mesh.triangles)))
{}

WallSurface::WallSurface(const TriangleMesh& mesh, const BoxTree& tree)
    : m_edges(mesh)
    , m_walls(wallsOf(mesh, tree))
    , m_tree(tree, normalsOf(mesh))
{}

std::vector<WallSurface::Wall> WallSurface::wallsOf(const TriangleMesh& mesh, const BoxTree& tree) const
{
    std::vector<Wall> walls(mesh.triangles.size());
    forEachChunk(walls.size(), facesAtOnce, [&](std::size_t, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            walls[i] = wallOf(mesh, tree.at(static_cast<Slot>(i)));
            walls[i].isAtEdge = m_edges.isAt(walls[i].face);
        }
    });
    return walls;
}

/// Returns bounds of the inward normals of the faces and of their edges and corners, by position.
std::vector<FaceBox> WallSurface::normalsOf(const TriangleMesh& mesh) const
{
    std::vector<FaceBox> normals(m_walls.size());
    forEachChunk(m_walls.size(), facesAtOnce, [&](std::size_t, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            normals[i].extend(-m_walls[i].normal.array());
            if (m_walls[i].isAtEdge)
                normals[i].extend(m_edges.normalsAt(m_walls[i].face, mesh.triangles[m_walls[i].face]));
        }
    });
    return normals;
}

WallSurface::Wall WallSurface::wallOf(const TriangleMesh& mesh, Slot face)
{
    Wall wall;
    for (std::size_t i = 0; i < 3; ++i)
        wall.corners[i] = mesh.points[mesh.triangles[face][i]];
    const auto [a, b, c] = core::cornersOf(mesh, face);
    const Vec3 normal = (b - a).cross(c - a);
    const double length = std::sqrt(normal.squaredNorm());
    wall.normal = length > 0 ? Vec3f((normal / length).cast<float>()) : Vec3f::Zero();
    wall.face = face;
    Vec3 longest = b - a;
    for (const Vec3& side : {Vec3(c - b), Vec3(a - c)})
        if (side.squaredNorm() > longest.squaredNorm())
            longest = side;
    wall.across = normal.cross(longest).normalized().cast<float>();
    const double atB = (b - a).dot(wall.across.cast<double>()), atC = (c - a).dot(wall.across.cast<double>());
    wall.least = static_cast<float>(std::min({0.0, atB, atC}));
    wall.most = static_cast<float>(std::max({0.0, atB, atC}));
    return wall;
}

std::array<Vec3, 3> WallSurface::cornersOf(Slot position) const
{
    const auto& [a, b, c] = m_walls[position].corners;
    return {a.cast<double>(), b.cast<double>(), c.cast<double>()};
}

Vec3 WallSurface::pointOf(Slot position, const Vec3& weights) const
{
    const auto [a, b, c] = cornersOf(position);
    return weights[0] * a + weights[1] * b + weights[2] * c;
}

double WallSurface::areaOf(Slot position) const
{
    const auto [a, b, c] = cornersOf(position);
    return (b - a).cross(c - a).norm() / 2;
}
} // namespace core
