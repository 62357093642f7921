#include "core/analysis/wall_edges.h"

#include "core/geometry/face_geometry.h"

#include <algorithm>
#include <cmath>

namespace core
{
namespace
{
/// A corner is pointed if its edges lie so far to one side of its mean normal, as a cosine: those of a round surface
/// do not.
constexpr double pointed = 0.1;

/// A side of a face, at the lower of its vertices.
struct Side
{
    Slot high, face, across;
};

/// The sides of all faces by their lower vertices: those of vertex v are [first[v], first[v + 1]).
struct Sides
{
    std::vector<std::size_t> first;
    std::vector<Side> sides;
};

std::pair<Slot, Slot> endsOf(const Triangle& triangle, Slot side)
{
    return std::minmax(Slot(triangle[(side + 1) % 3]), Slot(triangle[(side + 2) % 3]));
}

Sides sidesOf(const TriangleMesh& mesh)
{
    Sides all;
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

Vec3 normalOf(const TriangleMesh& mesh, Slot face)
{
    const auto [a, b, c] = cornersOf(mesh, face);
    return (b - a).cross(c - a).normalized();
}

double angleAt(const TriangleMesh& mesh, const Triangle& triangle, Slot corner)
{
    const Vec3 p = mesh.points[triangle[corner]].cast<double>();
    const Vec3 a = mesh.points[triangle[(corner + 1) % 3]].cast<double>() - p;
    const Vec3 b = mesh.points[triangle[(corner + 2) % 3]].cast<double>() - p;
    return std::atan2(a.cross(b).norm(), a.dot(b));
}
} // namespace

WallEdges::WallEdges(const TriangleMesh& mesh)
    : m_edgeOf(mesh.triangles.size(), {noSlot, noSlot, noSlot})
    , m_isAt(mesh.triangles.size(), 0)
{
    findEdges(mesh);
    if (!m_edges.empty())
        findCorners(mesh);
}

void WallEdges::findEdges(const TriangleMesh& mesh)
{
    Sides all = sidesOf(mesh);
    for (std::size_t v = 0; v + 1 < all.first.size(); ++v) {
        const std::span<Side> sides(all.sides.data() + all.first[v], all.first[v + 1] - all.first[v]);
        std::ranges::stable_sort(sides, {}, &Side::high);
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
        return; // all but a few edges of a fine model, without a root
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

/// Corners of bent edges, of which all edges of the mesh are looked at.
void WallEdges::findCorners(const TriangleMesh& mesh)
{
    std::vector<Slot> number(mesh.points.size(), noSlot);
    for (const Edge& edge : m_edges)
        for (const Slot vertex : edge.vertices)
            if (number[vertex] == noSlot) {
                number[vertex] = static_cast<Slot>(m_corners.size());
                m_corners.push_back({vertex, noSlot, 0, 0, Vec3::Zero(), false});
            }
    std::vector<std::vector<Vec3>> stars(m_corners.size());
    for (Slot f = 0; f < mesh.triangles.size(); ++f) {
        const Triangle& triangle = mesh.triangles[f];
        for (Slot i = 0; i < 3; ++i) {
            if (number[triangle[i]] == noSlot)
                continue;
            Corner& corner = m_corners[number[triangle[i]]];
            corner.face = f;
            corner.inward -= angleAt(mesh, triangle, i) * normalOf(mesh, f);
            stars[number[triangle[i]]].push_back(
                (mesh.points[triangle[(i + 1) % 3]] - mesh.points[triangle[i]]).cast<double>().normalized());
        }
    }
    const auto isPointed = [&](const Vec3& inward, const std::vector<Vec3>& star, double sign) {
        return std::ranges::all_of(star, [&](const Vec3& e) { return sign * inward.dot(e) > pointed; });
    };
    m_cornerOf.assign(mesh.points.size(), noSlot);
    std::vector<Corner> kept;
    for (std::size_t i = 0; i < m_corners.size(); ++i) {
        Corner corner = m_corners[i];
        corner.inward.normalize();
        corner.isInward = isPointed(corner.inward, stars[i], -1);
        if (!corner.isInward && !isPointed(corner.inward, stars[i], 1))
            continue;
        corner.first = m_star.size();
        corner.count = stars[i].size();
        for (const Vec3& e : stars[i])
            m_star.push_back(corner.isInward ? e : Vec3(-e));
        m_cornerOf[corner.vertex] = static_cast<Slot>(kept.size());
        kept.push_back(corner);
    }
    m_corners = std::move(kept);
    if (m_corners.empty())
        m_cornerOf.clear();
    for (Slot f = 0; f < mesh.triangles.size() && !m_corners.empty(); ++f)
        for (const Slot vertex : mesh.triangles[f])
            if (m_cornerOf[vertex] != noSlot)
                m_isAt[f] = 1;
}

bool WallEdges::isOpposite(const Corner& corner, const Vec3& inward) const
{
    return std::ranges::all_of(edgesAt(corner), [&](const Vec3& edge) { return inward.dot(edge) >= 0; });
}
} // namespace core
