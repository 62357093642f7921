#include "core/analysis/wall_surface.h"

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
    , m_tree(tree)
    , m_walls(mesh.triangles.size())
{
    forEachChunk(m_walls.size(), facesAtOnce, [&](std::size_t, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            m_walls[i] = wallOf(mesh, tree.at(static_cast<Slot>(i)));
            m_walls[i].isAtEdge = m_edges.isAt(m_walls[i].face);
        }
    });
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

/// Returns a bound from below of the squared distance, by the face's plane and by how wide it is across its longest
/// side: boxes of long thin faces are full of other faces.
double WallSurface::reach(Slot position, const Vec3& p) const
{
    constexpr double error = 1e-6;
    const Wall& wall = m_walls[position];
    const Vec3 way = p - wall.corners[0].cast<double>();
    const double off = error * way.lpNorm<1>();
    const double height = std::abs(way.dot(wall.normal.cast<double>())), aside = way.dot(wall.across.cast<double>());
    const double up = std::max(0.0, height - off);
    const double beside =
        std::max({0.0, static_cast<double>(wall.least) - aside - off, aside - static_cast<double>(wall.most) - off});
    return up * up + beside * beside;
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

bool WallSurface::areOpposite(Slot a, Slot b) const
{
    return static_cast<double>(m_walls[a].normal.dot(m_walls[b].normal)) < maxOppositeCosine;
}

bool WallSurface::mayTouch(Slot position, Slot other) const
{
    return areOpposite(position, other) || m_walls[other].isAtEdge;
}

} // namespace core
