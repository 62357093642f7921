// A tube is a surface of revolution, round at both ends, whose axis is bent along the curve: each of its rings is put
// across the curve.

#include "core/primitives/tube.h"

#include "core/analysis/mesh_check.h"
#include "core/primitives/revolved_surface.h"
#include "core/stroke/radial_symmetry.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace core
{
namespace
{
constexpr double quarterTurn = std::numbers::pi / 2;
constexpr int lengthSamples = 16; ///< chords by which the length of a span of the curve is estimated

using Vec4 = Eigen::Vector4d; ///< position and radius

Vec4 valueOf(const TubePoint& p)
{
    return {p.position.x(), p.position.y(), p.position.z(), p.radius};
}

/// A span of the curve between two points of the path.
class Span
{
public:
    /// Takes the point before the path's first, and behind its last, from the straight line on.
    Span(const std::vector<TubePoint>& path, std::size_t first)
    {
        m_values[1] = valueOf(path[first]);
        m_values[2] = valueOf(path[first + 1]);
        m_values[0] = first > 0 ? valueOf(path[first - 1]) : Vec4(2 * m_values[1] - m_values[2]);
        m_values[3] = first + 2 < path.size() ? valueOf(path[first + 2]) : Vec4(2 * m_values[2] - m_values[1]);
        for (std::size_t i = 1; i < m_values.size(); ++i)
            m_knots[i] = m_knots[i - 1] + std::sqrt((m_values[i] - m_values[i - 1]).head<3>().norm());
    }

    /// Returns the place and the radius at t, 0 to 1, by the pyramid of Barry and Goldman 1988.
    TubePoint at(double t) const
    {
        const double knot = m_knots[1] + t * (m_knots[2] - m_knots[1]);
        std::array<Vec4, 4> values = m_values;
        for (std::size_t level = 1; level < values.size(); ++level) {
            for (std::size_t i = 0; i + level < values.size(); ++i) {
                const bool isLast = level == 3;
                const std::size_t from = isLast ? 1 : i, to = isLast ? 2 : i + level;
                const double share = (knot - m_knots[from]) / (m_knots[to] - m_knots[from]);
                values[i] = (1 - share) * values[i] + share * values[i + 1];
            }
        }
        const auto [least, most] = std::minmax(m_values[1][3], m_values[2][3]);
        return {values[0].head<3>(), std::clamp(values[0][3], least, most)};
    }

    double length() const
    {
        double sum = 0;
        for (int i = 0; i < lengthSamples; ++i)
            sum += (at((i + 1.0) / lengthSamples).position - at(double(i) / lengthSamples).position).norm();
        return sum;
    }

private:
    std::array<Vec4, 4> m_values;
    std::array<double, 4> m_knots{};
};

/// Returns the axis that is most across a unit vector, made at a right angle to it.
Vec3 anyAcross(const Vec3& along)
{
    int axis = 0;
    along.cwiseAbs().minCoeff(&axis);
    const Vec3 unit = Vec3::Unit(axis);
    return (unit - unit.dot(along) * along).normalized();
}
} // namespace

Tube::Tube(const std::vector<TubePoint>& path, double edge) : m_edge(edge)
{
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
        const Span span(path, i);
        const int n = static_cast<int>(std::max(1.0, std::ceil(span.length() / edge)));
        for (int k = i == 0 ? 0 : 1; k <= n; ++k) {
            const TubePoint p = span.at(double(k) / n);
            m_rings.push_back({p.position, p.radius, Vec3::Zero(), Vec3::Zero()});
        }
    }
    turnRings();
}

/// Sets the directions of the rings. From one to the next, the vector across is reflected twice.
void Tube::turnRings()
{
    for (std::size_t i = 0; i < m_rings.size(); ++i) {
        const std::size_t before = i > 0 ? i - 1 : 0, after = std::min(i + 1, m_rings.size() - 1);
        const Vec3 chord = m_rings[after].centre - m_rings[before].centre;
        const bool turnsBack = chord.squaredNorm() == 0;
        m_rings[i].along = (turnsBack ? Vec3(m_rings[i].centre - m_rings[before].centre) : chord).normalized();
    }
    m_rings.front().across = anyAcross(m_rings.front().along);
    for (std::size_t i = 1; i < m_rings.size(); ++i) {
        const Ring& from = m_rings[i - 1];
        Ring& to = m_rings[i];
        const auto reflected = [](const Vec3& v, const Vec3& normal) -> Vec3 {
            const double squared = normal.squaredNorm();
            return squared > 0 ? Vec3(v - 2 / squared * normal.dot(v) * normal) : v;
        };
        const Vec3 step = to.centre - from.centre;
        const Vec3 across = reflected(from.across, step), along = reflected(from.along, step);
        to.across = reflected(across, to.along - along);
        to.across = (to.across - to.across.dot(to.along) * to.along).normalized();
    }
}

/// Returns the surface around the curve from one ring to another. Two rings alone are turned to each other, so that
/// their surface never crosses itself.
TriangleMesh Tube::swept(std::size_t first, std::size_t last) const
{
    std::vector<ProfilePoint> profile;
    std::vector<Ring> rings;    // for each point of the profile
    std::vector<double> beyond; // way of the point from its ring's centre along the axis
    const auto add = [&](std::size_t ring, double radius, double height, double away) {
        profile.push_back({radius, height + away});
        rings.push_back(m_rings[ring]);
        beyond.push_back(away);
    };
    const auto stepsOf = [this](double radius) {
        return std::max(2, static_cast<int>(std::ceil(quarterTurn * radius / (1.25 * m_edge))));
    };
    const double start = m_rings[first].radius, end = m_rings[last].radius;
    for (int i = 0, n = stepsOf(start); i < n; ++i) {
        const Turn turn = Turn::by(quarterTurn * i / n);
        add(first, i == 0 ? 0 : start * turn.sine, 0, -start * turn.cosine);
    }
    double height = 0;
    for (std::size_t i = first; i <= last; ++i) {
        if (i > first)
            height += (m_rings[i].centre - m_rings[i - 1].centre).norm();
        add(i, m_rings[i].radius, height, 0);
    }
    for (int n = stepsOf(end), i = n - 1; i >= 0; --i) {
        const Turn turn = Turn::by(quarterTurn * i / n);
        add(last, i == 0 ? 0 : end * turn.sine, height, end * turn.cosine);
    }
    if (last == first + 1) {
        const Vec3 along = (m_rings[last].centre - m_rings[first].centre).normalized();
        const Vec3 across = m_rings[first].across;
        for (Ring& ring : rings) {
            ring.along = along;
            ring.across = (across - across.dot(along) * along).normalized();
        }
    }

    TriangleMesh mesh = revolvedSurface(profile, false, m_edge);
    std::size_t at = 0; // vertices come ring by ring
    for (Vec3f& p : mesh.points) {
        while (static_cast<float>(profile[at].height) != p.y())
            ++at;
        const Ring& ring = rings[at];
        p = (ring.centre + beyond[at] * ring.along + double(p.x()) * ring.across +
             double(p.z()) * ring.across.cross(ring.along))
                .cast<float>();
    }
    return mesh;
}

std::vector<TriangleMesh> Tube::solids(std::size_t maxFaces, const JobControl& control) const
{
    std::vector<TriangleMesh> solids;
    if (!divide(0, m_rings.size() - 1, solids, maxFaces, control))
        solids.clear();
    return solids;
}

/// Appends sound solids for the rings from one to another. Returns false if that is not possible within `facesLeft`,
/// which counts down.
bool Tube::divide(std::size_t first, std::size_t last, std::vector<TriangleMesh>& solids, std::size_t& facesLeft,
                  const JobControl& control) const
{
    if (control.isCancelled())
        return false;
    TriangleMesh mesh = swept(first, last);
    if (checkMesh(mesh).printReady()) {
        const std::size_t faces = mesh.triangles.size();
        if (faces > facesLeft)
            return false;
        facesLeft -= faces;
        solids.push_back(std::move(mesh));
        return true;
    }
    const std::size_t middle = (first + last) / 2;
    return last > first + 1 && divide(first, middle, solids, facesLeft, control) &&
           divide(middle, last, solids, facesLeft, control);
}
} // namespace core
