// One round over the faces of a vertex: the sum of their normals, the two sharpest of the edges between them, and the
// mean curvature. Shaders make of these what needs both sides of a sharp edge, without a vertex for each side.
#include "core/mesh/draw_vertex.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace core
{
namespace
{
/// Between these angles of two faces, as cosines, an edge becomes sharp: 38 to 45 degrees. A step would flicker where a
/// crease runs along it.
constexpr double smoothCosine = 0.7880107536067220, sharpCosine = 0.7071067811865476;
/// Two sharp edges at a vertex are one line if it turns by less than this: 40 degrees.
constexpr double straightCosine = 0.7660444431189780;
/// The radius that counts as half of a sharp ridge, as a share of the longest coordinate that the lattice was made for.
constexpr double ridgeRadius = 0.025;
constexpr double latticeSteps = 1 << 20; ///< of that coordinate

/// Returns how sharp the edge between two faces of these normals is, 0 to 1. `squared`: the product of their squared
/// lengths. Costs no square root where it is not at all.
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

    /// One edge that ends at the vertex parts nothing there: both its sides are one surface.
    double sharpness() const { return m_edges[1].sharpness; }

    /// The line that the two sharpest make, of unit length; shorter the sharper the third one is, and zero if they make
    /// none.
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

/// The result of a round over the faces of a vertex.
struct Star
{
    Vec3 normal =
        Vec3::Zero();         ///< sum of the faces' normals, each as long as twice its area; exact, see vertexNormal()
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
