// Primitives: a box is a grid, a ball an icosphere, a tube a class of its own; all others are surfaces of revolution,
// whose profiles are divided into parts of about one edge length.

#include "core/primitives/primitives.h"

#include "core/analysis/mesh_check.h"
#include "core/analysis/nesting.h"
#include "core/boolean/mesh_boolean.h"
#include "core/geometry/face_geometry.h"
#include "core/geometry/lattice_placement.h"
#include "core/primitives/grid_box.h"
#include "core/primitives/model_limits.h"
#include "core/stroke/radial_symmetry.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace core
{
namespace
{
using PrimitiveKind = Primitive::Kind;
using Measure = Primitive::Measure;
using ProfilePoints = std::vector<ProfilePoint>;

constexpr double pi = std::numbers::pi;
constexpr double automaticFaces = 20'000;
constexpr double maxEdgePerRadius = 1.3; ///< longest edge on a ring of 8 vertices, as a share of its radius
/// Longest edge as a share of the largest radius, or of that of a torus's tube. Keeps 98 % of the volume.
constexpr double maxEdgePerRound = 1.0 / 6;
/// Least radius of a tube, and distance of two of its points, as shares of the largest coordinate: so that float32 has
/// about 100 steps for it.
constexpr double minPerReach = 1e-5;
const double faceShare = std::sqrt(3.0) / 4;

/// Returns the number of parts into which a length is divided: parts of at most 1.25 edges.
int partsOf(double length, double edge)
{
    return static_cast<int>(std::max(1.0, std::ceil(length / (1.25 * edge))));
}

double distanceOf(const ProfilePoint& a, const ProfilePoint& b)
{
    const double x = b.radius - a.radius, y = b.height - a.height;
    return std::sqrt(x * x + y * y);
}

/// Extends the profile by a straight line. The division is the same from either end.
void addLine(ProfilePoints& profile, const ProfilePoint& to, double edge)
{
    const ProfilePoint from = profile.back();
    const int n = partsOf(distanceOf(from, to), edge);
    for (int i = 1; i < n; ++i)
        profile.push_back({((n - i) * from.radius + i * to.radius) / n, ((n - i) * from.height + i * to.height) / n});
    profile.push_back(to);
}

ProfilePoints lines(std::initializer_list<ProfilePoint> points, double edge)
{
    ProfilePoints profile = {*points.begin()};
    for (const ProfilePoint& p : std::span(points).subspan(1))
        addLine(profile, p, edge);
    return profile;
}

/// Returns the cosine and sine of an angle of at most a quarter turn, in radians.
Turn turnBy(double angle)
{
    if (angle <= pi / 4)
        return Turn::by(angle);
    const Turn rest = Turn::by(std::max(0.0, pi / 2 - angle));
    return {rest.sine, rest.cosine};
}

/// Appends the lower half of a profile, mirrored. Its last point is at height 0.
ProfilePoints withUpperHalf(ProfilePoints profile, bool isClosed)
{
    for (std::size_t i = profile.size() - 1; i-- > (isClosed ? 1u : 0u);)
        profile.push_back({profile[i].radius, 0 - profile[i].height});
    return profile;
}

/// Returns the profile of a capsule. Its vertices are evenly spaced along the meridian, whatever the length of the
/// straight part.
ProfilePoints capsuleProfile(double radius, double height, double edge)
{
    const double straight = height / 2 - radius, arc = pi / 2 * radius;
    const int n = partsOf(arc + straight, edge);
    ProfilePoints profile = {{0, -height / 2}};
    for (int i = 1; i < n; ++i) {
        const double along = (arc + straight) * i / n;
        const Turn turn = turnBy(std::min(along, arc) / radius);
        profile.push_back(along < arc ? ProfilePoint{radius * turn.sine, -straight - radius * turn.cosine}
                                      : ProfilePoint{radius, along - arc - straight});
    }
    profile.push_back({radius, 0});
    return withUpperHalf(std::move(profile), false);
}

/// Returns the closed profile of a torus, beginning at its inner equator.
ProfilePoints torusProfile(double radius, double tube, double edge)
{
    const int n = partsOf(pi / 2 * tube, edge);
    ProfilePoints profile;
    for (int i = 0; i <= 2 * n; ++i) {
        const Turn turn = i <= n ? turnBy(pi / 2 * i / n) : turnBy(pi / 2 * (2 * n - i) / n);
        const double out = tube * (i <= n ? -turn.cosine : turn.cosine);
        profile.push_back({radius + out, i == 0 || i == 2 * n ? 0.0 : -tube * turn.sine});
    }
    return withUpperHalf(std::move(profile), true);
}

/// Returns a lathe's profile with its ends on the axis, and the middle of its height at 0.
ProfilePoints closedAtAxis(const ProfilePoints& given)
{
    const auto [low, high] = std::ranges::minmax_element(given, {}, &ProfilePoint::height);
    const double middle = (low->height + high->height) / 2;
    ProfilePoints profile;
    if (given.front().radius > 0)
        profile.push_back({0, given.front().height});
    profile.insert(profile.end(), given.begin(), given.end());
    if (given.back().radius > 0)
        profile.push_back({0, given.back().height});
    for (ProfilePoint& p : profile)
        p.height -= middle;
    return profile;
}

double longestEdge(const ProfilePoints& profile)
{
    double largest = 0, limit = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < profile.size(); ++i) {
        largest = std::max(largest, profile[i].radius);
        if (profile[i].radius > 0)
            limit = std::min(limit, maxEdgePerRadius * profile[i].radius);
        if (i > 0)
            limit = std::min(limit, distanceOf(profile[i - 1], profile[i]));
    }
    return std::min(limit, largest * maxEdgePerRound);
}

double areaOfRevolution(const ProfilePoints& profile)
{
    double area = 0;
    for (std::size_t i = 1; i < profile.size(); ++i)
        area += pi * (profile[i - 1].radius + profile[i].radius) * distanceOf(profile[i - 1], profile[i]);
    return area;
}

/// Returns about the area of a tube, from the straight lines between its points.
double areaOfTube(const std::vector<TubePoint>& path)
{
    double area = 2 * pi * (path.front().radius * path.front().radius + path.back().radius * path.back().radius);
    for (std::size_t i = 1; i < path.size(); ++i)
        area += pi * (path[i - 1].radius + path[i].radius) * (path[i].position - path[i - 1].position).norm();
    return area;
}

/// Drops the voids that are smaller than a cube of this side: rounding leaves them where pieces of a tube nearly
/// coincide.
void dropTinyVoids(TriangleMesh& mesh, double side)
{
    const Components shells = componentsOf(mesh.points.size(), mesh.triangles);
    if (shells.count == 1)
        return;
    std::vector<double> volumes(shells.count); // a void's is negative
    const auto place = [&](Slot v) { return Vec3((mesh.points[v] - mesh.points.front()).cast<double>()); };
    for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
        const auto& [a, b, c] = mesh.triangles[f];
        volumes[shells.ofFace[f]] += place(a).dot(place(b).cross(place(c))) / 6;
    }
    TriangleMesh kept;
    std::vector<Slot> renamed(mesh.points.size(), noSlot);
    for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
        const double volume = volumes[shells.ofFace[f]];
        if (volume < 0 && volume > -side * side * side)
            continue;
        Triangle t = mesh.triangles[f];
        for (Slot& v : t) {
            if (renamed[v] == noSlot) {
                renamed[v] = static_cast<Slot>(kept.points.size());
                kept.points.push_back(mesh.points[v]);
            }
            v = renamed[v];
        }
        kept.triangles.push_back(t);
    }
    mesh = std::move(kept);
}

/// Returns the union of a tube's pieces, on the lattice that an import of it would have, so that it can be opened as it
/// is.
std::optional<TriangleMesh> unionOf(std::vector<TriangleMesh> pieces, const JobControl& control)
{
    Box box;
    for (const TriangleMesh& piece : pieces)
        box.extend(boxOf(piece));
    const LatticePlacement placement = placeOnLattice(box);
    if (!placement.moved.isZero(0)) // an import would move it to the origin
        return combine(SetOperation::Union, pieces, control).mesh;
    for (TriangleMesh& piece : pieces) {
        for (Vec3f& p : piece.points)
            p = placement.lattice.toPoint(placement.toLattice(p));
    }
    return combineOn(placement.lattice, SetOperation::Union, pieces, control).mesh;
}

/// Returns the rotation that turns the y axis to a direction of unit length: the one of least angle, but steeply
/// downwards after half a turn about x, since there is no least one to -y. A level direction leaves an axis on the
/// plane y = 0, so that the solid is symmetric about it.
Eigen::Matrix3d rotationTo(const Vec3& up)
{
    constexpr double steeplyDown = -0.5;
    const double x = up.x(), y = up.y(), z = up.z(), f = 1 / (1 + y);
    if (y < steeplyDown)
        return rotationTo(-up) * Vec3(1, -1, -1).asDiagonal();
    Eigen::Matrix3d rotation;
    if (y == 0)
        rotation << 0, x, -z, //
            -1, 0, 0,         //
            0, z, x;
    else
        rotation << 1 - f * x * x, x, -f * x * z, //
            -x, y, -z,                            //
            -f * x * z, z, 1 - f * z * z;
    return rotation;
}

class PrimitiveMaker
{
public:
    explicit PrimitiveMaker(const Primitive& primitive)
        : m_primitive(primitive)
        , m_width(primitive.length(Measure::Width))
        , m_height(primitive.length(Measure::Height))
        , m_depth(primitive.length(Measure::Depth))
        , m_radius(primitive.length(Measure::Radius))
        , m_topRadius(primitive.length(Measure::TopRadius))
        , m_tubeRadius(primitive.length(Measure::TubeRadius))
    {}

    PrimitiveResult judged()
    {
        judge();
        if (m_result.fault == PrimitiveFault::None)
            chooseEdge();
        return m_result;
    }

    PrimitiveResult run(const JobControl& control)
    {
        if (judged().fault != PrimitiveFault::None)
            return std::move(m_result);
        if (m_primitive.kind == PrimitiveKind::Tube) {
            makeTube(control);
            return std::move(m_result);
        }
        m_result.mesh = surface();
        if (hasAxis(m_primitive.kind) && m_primitive.axis != Vec3::UnitY()) {
            const Eigen::Matrix3d rotation = rotationOf(m_primitive);
            for (Vec3f& p : m_result.mesh->points)
                p = (rotation * p.cast<double>()).cast<float>();
        }
        if (m_primitive.kind == PrimitiveKind::Lathe && !checkMesh(*m_result.mesh).printReady()) {
            m_result.mesh.reset();
            m_result.fault = PrimitiveFault::ProfileMeets;
        }
        return std::move(m_result);
    }

private:
    static bool isExtent(double length) { return length >= ModelLimits::minExtent && length <= ModelLimits::maxExtent; }

    void judge()
    {
        for (const Measure measure : measuresOf(m_primitive.kind)) {
            const double length = m_primitive.length(measure);
            if (!isExtent(length) && !(measure == Measure::TopRadius && length == 0)) {
                m_result.fault = PrimitiveFault::Measure;
                m_result.measure = measure;
                return;
            }
        }
        if (m_primitive.kind == PrimitiveKind::Torus && m_radius <= m_tubeRadius)
            m_result.fault = PrimitiveFault::TubeTooThick;
        if (m_primitive.kind == PrimitiveKind::Capsule && m_height <= 2 * m_radius)
            m_result.fault = PrimitiveFault::CapsuleTooLow;
        if (m_primitive.kind == PrimitiveKind::Lathe && !isProfileGood())
            m_result.fault = PrimitiveFault::Profile;
        if (m_primitive.kind == PrimitiveKind::Tube && !isPathGood())
            m_result.fault = PrimitiveFault::Path;
    }

    bool isPathGood() const
    {
        const std::vector<TubePoint>& path = m_primitive.path;
        const auto reachOf = [](const TubePoint& p) { return p.position.cwiseAbs().maxCoeff(); };
        double reach = 0;
        for (const TubePoint& p : path)
            reach = std::max(reach, p.position.allFinite() ? reachOf(p) : INFINITY);
        const double least = std::max(ModelLimits::minExtent, minPerReach * reach);
        const auto isThin = [&](const TubePoint& p) { return !(p.radius >= least && isExtent(p.radius)); };
        const auto isNear = [&](const TubePoint& a, const TubePoint& b) {
            return (a.position - b.position).norm() < least;
        };
        return path.size() >= 2 && path.size() <= PrimitiveLimits::maxProfile && reach <= ModelLimits::maxExtent &&
               std::ranges::none_of(path, isThin) && std::ranges::adjacent_find(path, isNear) == path.end();
    }

    /// Makes one solid of the tube's pieces.
    void makeTube(const JobControl& control)
    {
        constexpr auto limit = static_cast<std::size_t>(PrimitiveLimits::maxFaces);
        std::vector<TriangleMesh> solids = Tube(m_primitive.path, m_edge).solids(limit, control);
        if (solids.size() == 1)
            m_result.mesh = std::move(solids.front());
        else if (!solids.empty())
            m_result.mesh = unionOf(std::move(solids), control);
        if (m_result.mesh)
            dropTinyVoids(*m_result.mesh, m_edge);
        if (!m_result.mesh)
            m_result.fault = PrimitiveFault::PathMeets;
    }

    bool isProfileGood() const
    {
        const ProfilePoints& profile = m_primitive.profile;
        if (profile.size() < 2 || profile.size() > PrimitiveLimits::maxProfile)
            return false;
        for (std::size_t i = 0; i < profile.size(); ++i) {
            const bool isEnd = i == 0 || i + 1 == profile.size();
            if (!(isExtent(profile[i].radius) || (isEnd && profile[i].radius == 0)) ||
                !(std::abs(profile[i].height) <= ModelLimits::maxExtent) ||
                (i > 0 && distanceOf(profile[i - 1], profile[i]) < ModelLimits::minExtent))
                return false;
        }
        return profile.size() > 2 || profile.front().radius > 0 || profile.back().radius > 0;
    }

    void chooseEdge()
    {
        const double limit = longest();
        m_edge = m_primitive.edge;
        if (m_edge == 0)
            m_edge = std::min(limit, std::sqrt(area() / (faceShare * automaticFaces)));
        m_result.limit = limit;
        m_result.faces = area() / (faceShare * m_edge * m_edge);
        if (!(m_edge > 0) || m_edge > limit)
            m_result.fault = PrimitiveFault::EdgeTooLong;
        else if (m_result.faces > PrimitiveLimits::maxFaces)
            m_result.fault = PrimitiveFault::TooManyFaces;
    }

    /// Returns the corners of the profile of a cylinder, cone or lathe, from axis to axis.
    ProfilePoints outline() const
    {
        const double top = m_primitive.kind == PrimitiveKind::Cylinder ? m_radius : m_topRadius, half = m_height / 2;
        if (m_primitive.kind == PrimitiveKind::Lathe)
            return closedAtAxis(m_primitive.profile);
        return closedAtAxis({{m_radius, -half}, {top, half}});
    }

    /// Returns the longest edge with which the mesh follows the shape, mm.
    double longest() const
    {
        switch (m_primitive.kind) {
        case PrimitiveKind::Cuboid:
            return std::min({m_width, m_height, m_depth});
        case PrimitiveKind::Ball:
        case PrimitiveKind::Capsule:
            return m_radius * maxEdgePerRound;
        case PrimitiveKind::Torus:
            return std::min(m_tubeRadius * maxEdgePerRound, maxEdgePerRadius * (m_radius - m_tubeRadius));
        case PrimitiveKind::Tube: {
            const auto [thin, thick] = std::ranges::minmax(m_primitive.path, {}, &TubePoint::radius);
            return std::min(thick.radius * maxEdgePerRound, maxEdgePerRadius * thin.radius);
        }
        default:
            return longestEdge(outline());
        }
    }

    double area() const
    {
        switch (m_primitive.kind) {
        case PrimitiveKind::Cuboid:
            return 2 * (m_width * m_height + m_height * m_depth + m_depth * m_width);
        case PrimitiveKind::Ball:
            return 4 * pi * m_radius * m_radius;
        case PrimitiveKind::Capsule:
            return 2 * pi * m_radius * m_height;
        case PrimitiveKind::Torus:
            return 4 * pi * pi * m_radius * m_tubeRadius;
        case PrimitiveKind::Tube:
            return areaOfTube(m_primitive.path);
        default:
            return areaOfRevolution(outline());
        }
    }

    TriangleMesh surface() const
    {
        const auto cells = [this](double length) { return 2 * partsOf(length / 2, m_edge); };
        switch (m_primitive.kind) {
        case PrimitiveKind::Cuboid:
            return gridBox({cells(m_width), cells(m_height), cells(m_depth)}, {m_width, m_height, m_depth});
        case PrimitiveKind::Ball:
            return ball();
        case PrimitiveKind::Cylinder:
            return revolvedSurface(
                withUpperHalf(lines({{0, -m_height / 2}, {m_radius, -m_height / 2}, {m_radius, 0}}, m_edge), false),
                false, m_edge);
        case PrimitiveKind::Capsule:
            return revolvedSurface(capsuleProfile(m_radius, m_height, m_edge), false, m_edge);
        case PrimitiveKind::Torus:
            return revolvedSurface(torusProfile(m_radius, m_tubeRadius, m_edge), true, m_edge);
        default:
            break;
        }
        const ProfilePoints corners = outline();
        ProfilePoints profile = {corners.front()};
        for (const ProfilePoint& p : std::span(corners).subspan(1))
            addLine(profile, p, m_edge);
        return revolvedSurface(profile, false, m_edge);
    }

    /// Returns the icosphere whose edges are nearest to the requested ones.
    TriangleMesh ball() const
    {
        constexpr double meanEdge = 1.15; // of an icosphere, times its radius and 2^subdivisions
        int subdivisions = 0;
        for (double edge = meanEdge * m_radius; edge > std::numbers::sqrt2 * m_edge; edge /= 2)
            ++subdivisions;
        return icosphere(subdivisions, m_radius);
    }

    const Primitive& m_primitive;
    const double m_width, m_height, m_depth, m_radius, m_topRadius, m_tubeRadius;
    PrimitiveResult m_result;
    double m_edge = 0;
};
} // namespace

Vec3 nearestAxis(const Vec3& direction)
{
    int axis = 0;
    direction.cwiseAbs().maxCoeff(&axis);
    return (direction[axis] < 0 ? -1 : 1) * Vec3::Unit(axis);
}

Eigen::Matrix3d rotationOf(const Primitive& primitive)
{
    const Vec3 up = primitive.axis.stableNormalized();
    if (up != Vec3::UnitX() && up != Vec3::UnitZ())
        return rotationTo(up);
    Eigen::Matrix3d rotation = Eigen::Matrix3d::Zero();
    for (int i = 0; i < 3; ++i)
        rotation((i + (up == Vec3::UnitX() ? 2 : 1)) % 3, i) = 1;
    return rotation;
}

PrimitiveResult judgePrimitive(const Primitive& primitive)
{
    return PrimitiveMaker(primitive).judged();
}

PrimitiveResult makePrimitive(const Primitive& primitive, const JobControl& control)
{
    return PrimitiveMaker(primitive).run(control);
}
} // namespace core
