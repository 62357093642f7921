// Surfaces of revolution. A quarter of each strip between two rings is triangulated by the shorter diagonals; the other
// quarters are its mirror images.

#include "core/primitives/revolved_surface.h"

#include "core/geometry/face_geometry.h"
#include "core/stroke/radial_symmetry.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace core
{
namespace
{
constexpr double quarter = std::numbers::pi / 2;
/// Squared lengths of two diagonals that differ by less than this share are taken as equal.
constexpr double equalShare = 1e-9;

/// The vertices that a point of the profile becomes.
struct Ring
{
    ProfilePoint at;
    Slot perQuarter = 0; ///< number of vertices in a quarter turn; 0: a single vertex on the axis
    Slot first = 0;      ///< index of the first vertex

    /// Returns the vertex that is the image in quarter q of vertex i of the first quarter, 0 <= i <= perQuarter. Odd
    /// quarters are mirror images.
    Slot vertex(Slot q, Slot i) const
    {
        if (perQuarter == 0)
            return first;
        const Slot turned = q % 2 == 0 ? q * perQuarter + i : (q + 1) * perQuarter - i;
        return first + turned % (4 * perQuarter);
    }
};

/// Returns i/n of a quarter turn. The cosine of i/n is the sine of (n - i)/n bit for bit.
Turn partOfQuarter(Slot i, Slot n)
{
    if (i == 0)
        return {1, 0};
    if (2 * i == n)
        return {std::sqrt(0.5), std::sqrt(0.5)};
    if (2 * i > n) {
        const Turn rest = partOfQuarter(n - i, n);
        return {rest.sine, rest.cosine};
    }
    return Turn::by(quarter * i / n);
}

class Revolution
{
public:
    explicit Revolution(double edge) : m_edge(edge) {}

    void addRing(const ProfilePoint& at)
    {
        Ring ring{at, 0, static_cast<Slot>(m_mesh.points.size())};
        if (at.radius > 0)
            ring.perQuarter = static_cast<Slot>(std::max(2.0, std::floor(quarter * at.radius / m_edge + 0.5)));
        m_rings.push_back(ring);
        if (ring.perQuarter == 0)
            m_mesh.points.push_back(Vec3(0, at.height, 0).cast<float>());
        for (Slot i = 0; i < 4 * ring.perQuarter; ++i) {
            const Turn turn = partOfQuarter(i % ring.perQuarter, ring.perQuarter);
            const double along = at.radius * turn.cosine, across = at.radius * turn.sine;
            const std::array<Vec3, 4> images = {Vec3(along, at.height, across), Vec3(0 - across, at.height, along),
                                                Vec3(0 - along, at.height, 0 - across),
                                                Vec3(across, at.height, 0 - along)};
            m_mesh.points.push_back(images[i / ring.perQuarter].cast<float>());
        }
    }

    void addStrip(std::size_t from, std::size_t to)
    {
        const Ring &a = m_rings[from], &b = m_rings[to];
        Slot i = 0, j = 0;
        while (i < a.perQuarter || j < b.perQuarter) {
            const bool stepsA = j == b.perQuarter || (i < a.perQuarter && isFirstShorter(a, i, b, j));
            for (Slot q = 0; q < 4; ++q) {
                Triangle t = {a.vertex(q, i), b.vertex(q, j), stepsA ? a.vertex(q, i + 1) : b.vertex(q, j + 1)};
                if (q % 2 == 1)
                    std::swap(t[1], t[2]);
                m_mesh.triangles.push_back(t);
            }
            ++(stepsA ? i : j);
        }
    }

    TriangleMesh take() { return std::move(m_mesh); }

private:
    /// Returns whether the diagonal from a's next vertex is shorter than that from b's. If both are equally long, the
    /// answer alternates along the ring and does not change if heights are mirrored.
    bool isFirstShorter(const Ring& a, Slot i, const Ring& b, Slot j) const
    {
        const double first = squaredLength(a, i + 1, b, j), second = squaredLength(a, i, b, j + 1);
        if (std::abs(first - second) > equalShare * (first + second))
            return first < second;
        const double heightA = std::abs(a.at.height), heightB = std::abs(b.at.height);
        const bool isOuterA = heightA != heightB ? heightA > heightB : a.at.radius > b.at.radius;
        return isOuterA == (std::min(i, j) % 2 == 0);
    }

    double squaredLength(const Ring& a, Slot i, const Ring& b, Slot j) const
    {
        return (m_mesh.points[a.vertex(0, i)] - m_mesh.points[b.vertex(0, j)]).cast<double>().squaredNorm();
    }

    double m_edge;
    TriangleMesh m_mesh;
    std::vector<Ring> m_rings;
};
} // namespace

TriangleMesh revolvedSurface(const std::vector<ProfilePoint>& profile, bool isClosed, double edge)
{
    Revolution revolution(edge);
    for (const ProfilePoint& p : profile)
        revolution.addRing(p);
    for (std::size_t i = 0; i + 1 < profile.size(); ++i)
        revolution.addStrip(i, i + 1);
    if (isClosed)
        revolution.addStrip(profile.size() - 1, 0);
    TriangleMesh mesh = revolution.take();
    double volume = 0;
    for (const auto& [a, b, c] : mesh.triangles)
        volume += mesh.points[a].cast<double>().dot(mesh.points[b].cast<double>().cross(mesh.points[c].cast<double>()));
    if (volume < 0) {
        for (Triangle& t : mesh.triangles)
            std::swap(t[1], t[2]);
    }
    return mesh;
}
} // namespace core
