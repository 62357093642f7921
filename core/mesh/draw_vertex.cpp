// Computes, in one pass over the faces around a vertex, the sum of their normals, the two sharpest edges and the mean
// curvature. From these the shaders restore the normals on both sides of a sharp edge, with only one vertex in the
// buffer.
#include "core/mesh/draw_vertex.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace core
{
namespace
{
/// Cosines of the angles between two faces at which their edge begins to be sharp (38 degrees) and is fully sharp (45
/// degrees). A hard threshold would flicker along a crease near it.
constexpr double smoothCosine = 0.7880107536067220, sharpCosine = 0.7071067811865476;
/// Cosine of the largest turn, 40 degrees, at which two sharp edges at a vertex are one line.
constexpr double straightCosine = 0.7660444431189780;
/// Radius of curvature for which the curvature byte is half way between flat and a sharp ridge, as a share of the
/// largest coordinate that the lattice was made for.
constexpr double ridgeRadius = 0.025;
constexpr double latticeSteps = 1 << 20; ///< largest coordinate that the lattice was made for, lattice units

/// Returns how sharp the edge between two faces is, 0 to 1. a, b: normals of the faces; `squared`: product of their
/// squared lengths. Cost: no square root for a smooth edge.
double sharpness(const Vec3& a, const Vec3& b, double squared)
{
    const double along = a.dot(b);
    if (along > 0 && along * along >= smoothCosine * smoothCosine * squared)
        return 0;
    return std::min((smoothCosine - along / std::sqrt(squared)) / (smoothCosine - sharpCosine), 1.0);
}

/// The three sharpest edges at a vertex.
class SharpEdges
{
public:
    void add(double sharpness, const Vec3& spoke)
    {
        if (sharpness <= m_edges.back().sharpness)
            return;
        m_edges.back() = {sharpness, spoke};
        for (std::size_t i = m_edges.size() - 1; i > 0 && m_edges[i].sharpness > m_edges[i - 1].sharpness; --i)
            std::swap(m_edges[i], m_edges[i - 1]);
    }

    /// Returns the sharpness of the second-sharpest edge, 0 to 1. A single sharp edge that ends at the vertex does not
    /// count: the surface continues around its end.
    double sharpness() const { return m_edges[1].sharpness; }

    /// Returns the direction of the line through the two sharpest edges, or zero if they turn too much. Its length is 1
    /// if the third edge is smooth, and falls to 0 as that edge becomes as sharp as the second.
    Vec3 line() const
    {
        const Vec3 there = m_edges[0].spoke.normalized(), back = m_edges[1].spoke.normalized();
        if (there.dot(back) > -straightCosine)
            return Vec3::Zero();
        return (there - back).normalized() * (1 - m_edges[2].sharpness / sharpness());
    }

private:
    struct Edge
    {
        double sharpness = 0;
        Vec3 spoke = Vec3::Zero();
    };
    std::array<Edge, 3> m_edges;
};

/// Sums over the faces around a vertex.
struct Star
{
    /// Sum of the faces' normals, each as long as twice its face's area; exact, see vertexNormal().
    Vec3 normal = Vec3::Zero();
    Vec3 pull = Vec3::Zero(); ///< mean of the spokes, each divided by its squared length; 1/mm
    SharpEdges sharp;
};

Star starOf(const Mesh& mesh, Slot v)
{
    Star star;
    const Vec3 p = mesh.point(v).cast<double>();
    const auto spokeOf = [&](Slot h) { return Vec3(mesh.point(mesh.to(h)).cast<double>() - p); };
    const Slot first = mesh.outgoing(v);
    const Vec3 firstSpoke = spokeOf(first);
    Vec3 spoke = firstSpoke, before = Vec3::Zero(), firstFace = Vec3::Zero();
    double squaredBefore = 0, squaredFirst = 0;
    int valence = 0;
    Slot h = first;
    do {
        h = mesh.rotate(h);
        const Vec3 next = spokeOf(h), face = spoke.cross(next);
        const double squared = face.squaredNorm();
        star.normal += face;
        star.pull += spoke / spoke.squaredNorm();
        if (valence++ == 0)
            firstFace = face, squaredFirst = squared;
        else
            star.sharp.add(sharpness(before, face, squaredBefore * squared), spoke);
        before = face, squaredBefore = squared;
        spoke = next;
    } while (h != first);
    star.sharp.add(sharpness(before, firstFace, squaredBefore * squaredFirst), firstSpoke);
    star.pull /= valence;
    return star;
}

std::uint8_t curvatureByte(const Mesh& mesh, const Star& star, const Vec3& unitNormal)
{
    const double curvature = -2 * star.pull.dot(unitNormal); // 1/mm, positive on a ridge
    const double relative = curvature * ridgeRadius * latticeSteps * mesh.lattice().unit();
    return static_cast<std::uint8_t>(DrawVertex::flat + std::lrint(127 * relative / (1 + std::abs(relative))));
}

std::int8_t toByte(double x)
{
    return static_cast<std::int8_t>(std::lrint(127 * x));
}
} // namespace

DrawVertex drawVertex(const Mesh& mesh, Slot v)
{
    if (!mesh.isVertex(v))
        return {Vec3f::Zero(), {}, {}, {}};
    const Star star = starOf(mesh, v);
    const double length = star.normal.norm();
    const Vec3 n = length > 0 ? Vec3(star.normal / length) : Vec3::Zero();
    const Rgb c = mesh.color(v);
    DrawVertex drawn{mesh.point(v),
                     {toByte(n.x()), toByte(n.y()), toByte(n.z()), static_cast<std::int8_t>(mesh.mask(v) / 2)},
                     {c.r, c.g, c.b, curvatureByte(mesh, star, n)}};
    if (const double sharp = star.sharp.sharpness(); sharp > 0) {
        const Vec3 line = star.sharp.line();
        drawn.crease = {toByte(line.x()), toByte(line.y()), toByte(line.z()), toByte(sharp)};
    }
    return drawn;
}
} // namespace core
