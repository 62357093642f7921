#include "core/print/wall_edges.h"

#include "core/geometry/face_geometry.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace core
{
namespace
{
/// Least cosine between each edge of a pointed corner and its mean normal. Vertices of a round surface do not reach it.
constexpr double pointed = 0.1;

/// A side of a face, stored at the lower of its two vertices. `across`: index of the opposite corner.
struct EdgeSide
{
    Slot high, face, across;
};

/// The sides of all faces, grouped by lower vertex: those of vertex v are [first[v], first[v + 1]).
struct EdgeSides
{
    std::vector<std::size_t> first;
    std::vector<EdgeSide> sides;
};

std::pair<Slot, Slot> endsOf(const Triangle& triangle, Slot side)
{
    return std::minmax(Slot(triangle[(side + 1) % 3]), Slot(triangle[(side + 2) % 3]));
}

EdgeSides sidesOf(const TriangleMesh& mesh)
{
    EdgeSides all;
    all.first.assign(mesh.points.size() + 2, 0);
    for (const Triangle& triangle : mesh.triangles)
        for (Slot i = 0; i < 3; ++i)
            ++all.first[endsOf(triangle, i).first + 2];
    for (std::size_t v = 2; v < all.first.size(); ++v)
        all.first[v] += all.first[v - 1];
    all.sides.resize(3 * mesh.triangles.size());
    for (Slot f = 0; f < mesh.triangles.size(); ++f)
        for (Slot i = 0; i < 3; ++i) {
            const auto [low, high] = endsOf(mesh.triangles[f], i);
            all.sides[all.first[low + 1]++] = {high, f, i};
        }
    all.first.pop_back();
    return all;
}

Vec3 edgeFrom(const TriangleMesh& mesh, const Triangle& triangle, Slot corner)
{
    return mesh.points[triangle[(corner + 1) % 3]].cast<double>() - mesh.points[triangle[corner]].cast<double>();
}

/// Returns the mean normal at each vertex, weighted by angle and pointing into the matter; zero without faces.
std::vector<Vec3> meanNormals(const TriangleMesh& mesh)
{
    std::vector<Vec3> normals(mesh.points.size(), Vec3::Zero());
    for (const Triangle& triangle : mesh.triangles) {
        const std::array<Vec3, 3> edges = {edgeFrom(mesh, triangle, 0), edgeFrom(mesh, triangle, 1),
                                           edgeFrom(mesh, triangle, 2)};
        const Vec3 normal = edges[0].cross(edges[1]);
        const double twiceArea = normal.norm();
        for (std::size_t i = 0; i < 3 && twiceArea > 0; ++i) {
            const double angle = std::atan2(twiceArea, -edges[i].dot(edges[(i + 2) % 3]));
            normals[triangle[i]] -= angle / twiceArea * normal;
        }
    }
    for (Vec3& normal : normals)
        normal.normalize();
    return normals;
}
} // namespace

WallEdges::WallEdges(const TriangleMesh& mesh)
    : m_edgeOf(mesh.triangles.size(), {noSlot, noSlot, noSlot})
    , m_isAt(mesh.triangles.size(), 0)
{
    findEdges(mesh);
    findCorners(mesh);
}

void WallEdges::findEdges(const TriangleMesh& mesh)
{
    EdgeSides all = sidesOf(mesh);
    for (std::size_t v = 0; v + 1 < all.first.size(); ++v) {
        const std::span<EdgeSide> sides(all.sides.data() + all.first[v], all.first[v + 1] - all.first[v]);
        std::ranges::stable_sort(sides, {}, &EdgeSide::high);
        for (std::size_t i = 0; i + 1 < sides.size(); ++i)
            if (sides[i].high == sides[i + 1].high) {
                addEdge(mesh, {sides[i].face, sides[i + 1].face}, {sides[i].across, sides[i + 1].across});
                ++i;
            }
    }
}

void WallEdges::addEdge(const TriangleMesh& mesh, const std::array<Slot, 2>& faces, const std::array<Slot, 2>& sides)
{
    const auto [a, b, c] = cornersOf(mesh, faces[0]);
    const auto [d, e, f] = cornersOf(mesh, faces[1]);
    const Vec3 normal = (b - a).cross(c - a), other = (e - d).cross(f - d);
    const double bend = normal.dot(other), size2 = normal.squaredNorm() * other.squaredNorm();
    if (!(size2 > 0) || (bend > 0 && bend * bend >= maxInwardCosine * maxInwardCosine * size2))
        return; // rejects most edges of a fine model without a square root
    const Triangle& triangle = mesh.triangles[faces[0]];
    const auto at = [&](Slot vertex) { return Vec3(mesh.points[vertex].cast<double>()); };
    Edge edge;
    edge.vertices = {triangle[(sides[0] + 1) % 3], triangle[(sides[0] + 2) % 3]};
    edge.faces = faces;
    const Vec3 start = at(edge.vertices[0]), ownTip = at(triangle[sides[0]]),
               otherTip = at(mesh.triangles[faces[1]][sides[1]]);
    edge.isInward = normal.dot(otherTip - start) > 0;
    if (!edge.isInward && bend >= maxOutwardCosine * std::sqrt(size2))
        return;
    edge.along = (at(edge.vertices[1]) - start).normalized();
    edge.inward = {-normal.normalized(), -other.normalized()};
    for (std::size_t i = 0; i < 2; ++i) {
        const Vec3 tip = (i == 0 ? ownTip : otherTip) - start;
        const Vec3 across = (tip - tip.dot(edge.along) * edge.along).normalized();
        edge.across[i] = edge.isInward ? across : Vec3(-across);
        m_edgeOf[faces[i]][sides[i]] = static_cast<Slot>(m_edges.size());
        m_isAt[faces[i]] = 1;
    }
    m_edges.push_back(edge);
}

/// Examines all vertices, because the edges at a tip with many sides are hardly bent. A corner that juts outwards
/// counts only at a bent edge: around a round tip the faces themselves are opposite.
void WallEdges::findCorners(const TriangleMesh& mesh)
{
    const std::vector<Vec3> inward = meanNormals(mesh);
    std::vector<std::uint8_t> isInward(mesh.points.size(), 1), isOutward(mesh.points.size(), 0);
    for (const Edge& edge : m_edges)
        for (const Slot vertex : edge.vertices)
            isOutward[vertex] = 1;
    for (const Triangle& triangle : mesh.triangles)
        for (Slot i = 0; i < 3; ++i) {
            const Slot vertex = triangle[i];
            const Vec3 edge = edgeFrom(mesh, triangle, i);
            const double along = inward[vertex].dot(edge), least = pointed * edge.norm();
            isInward[vertex] &= along < -least ? 1 : 0;
            isOutward[vertex] &= along > least ? 1 : 0;
        }
    m_cornerOf.assign(mesh.points.size(), noSlot);
    for (Slot f = 0; f < mesh.triangles.size(); ++f)
        for (const Slot vertex : mesh.triangles[f]) {
            if (isInward[vertex] == 0 && isOutward[vertex] == 0)
                continue;
            m_isAt[f] = 1;
            if (m_cornerOf[vertex] == noSlot) {
                m_cornerOf[vertex] = static_cast<Slot>(m_corners.size());
                m_corners.push_back({vertex, f, 0, 0, inward[vertex], isInward[vertex] != 0});
            }
            ++m_corners[m_cornerOf[vertex]].count;
        }
    addStars(mesh);
}

void WallEdges::addStars(const TriangleMesh& mesh)
{
    std::size_t size = 0;
    for (Corner& corner : m_corners) {
        corner.first = size;
        size += std::exchange(corner.count, 0);
    }
    m_star.resize(size);
    for (Slot f = 0; f < mesh.triangles.size(); ++f)
        for (Slot i = 0; i < 3 && m_isAt[f] != 0; ++i)
            if (const Slot number = m_cornerOf[mesh.triangles[f][i]]; number != noSlot) {
                Corner& corner = m_corners[number];
                const Vec3 edge = edgeFrom(mesh, mesh.triangles[f], i).normalized();
                m_star[corner.first + corner.count++] = corner.isInward ? edge : Vec3(-edge);
            }
}

/// All normals of an edge are between those of its two faces. Divided by the cosine of half the angle between them,
/// these two span a segment beyond the arc of the normals.
FaceBox WallEdges::normalsAt(Slot face, const Triangle& corners) const
{
    constexpr double flat = 0.05;
    FaceBox box;
    const auto extendToAll = [&] {
        box.extend(Eigen::Array3f::Constant(-1));
        box.extend(Eigen::Array3f::Constant(1));
    };
    for (std::size_t i = 0; i < 3; ++i) {
        if (m_cornerOf[corners[i]] != noSlot)
            extendToAll();
        if (m_edgeOf[face][i] == noSlot)
            continue;
        const auto& [one, other] = m_edges[m_edgeOf[face][i]].inward;
        const double half = (one + other).norm() / 2;
        if (half < flat)
            extendToAll();
        for (const Vec3& normal : {one, other})
            box.extend((normal / std::max(half, flat)).cast<float>().array());
    }
    return box;
}

bool WallEdges::isOpposite(const Corner& corner, const Vec3& inward) const
{
    return std::ranges::all_of(edgesAt(corner), [&](const Vec3& edge) { return inward.dot(edge) >= 0; });
}
} // namespace core
