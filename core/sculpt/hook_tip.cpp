#include "core/sculpt/hook_tip.h"

#include "core/geometry/point_triangle.h"
#include "core/mesh/normals.h"
#include "core/sculpt/boolean_dab.h"
#include "core/sculpt/remesh/remesh.h"
#include "core/sculpt/select/selector.h"
#include "core/sculpt/verified_remesh.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace core
{
namespace
{
/// Shortest distance, in radii, between a tip and the place where the stroke took hold for the tip to join. A closer
/// tip would join the surface around its own root.
constexpr double minWay = 1;
/// Range of distances behind the tip, in radii, within which vertices are used to measure its cross-section.
constexpr double sectionBegin = 0.3, sectionEnd = 0.6;
/// Largest distance from the section's centre to a surface in reach, and to the first surface straight ahead, both in
/// radii of the section. reachDistance is more than 1, so that the union comes before the rim of the tip touches the
/// surface.
constexpr double reachDistance = 1.3, maxGap = 4;
/// Distance within which faces are examined, in radii of the section.
constexpr double farthest = maxGap + 2;
/// Smallest cosine of the angle between the heading and the direction to a surface in reach. For a mirror plane, whose
/// bridge is a mitre, the smallest cosine of the angle between the heading and the plane's normal.
constexpr double minAhead = 0.2, minTowardsPlane = 0.5;
/// The capsule's radius, the length of its rear cap, and how far its sides start behind the tip, all in radii of the
/// section. The capsule is slightly wider than the section and narrows just behind it, so that the two surfaces cross
/// in a single closed curve.
constexpr double capsuleRadius = 1.03, rearLength = 0.5, overlap = 0.6;
/// Largest depth of the capsule in the reached surface, as a share of the wall's thickness.
constexpr double maxDepthShare = 0.5;
/// With a mirror, distance of the ray straight ahead from the section's centre, in radii of the section: a ray in the
/// plane would meet edges.
constexpr double startAside = 0.02;
/// Height of the part of a half sphere that becomes the tube to the mirror plane; the rest becomes its rear end.
constexpr double tubeShare = 0.6;
/// Subdivisions of the icosahedron that the capsule is made of: edges of 0.13 to 0.16 radii.
constexpr int subdivisions = 3;
constexpr int smoothings = 3;

/// A cross-section of the tentacle, just behind its tip.
struct Section
{
    Vec3 center = Vec3::Zero();  ///< centre, mm; in the plane through the tip
    double radius = 0;           ///< mean radius, mm; 0 if there are no vertices behind the tip
    Vec3 heading = Vec3::Zero(); ///< of the tentacle; unit length
};

/// Measures the cross-section at the tip. `tip` and `heading`: the tip's position and the tentacle's direction there.
Section sectionAt(const Vec3& tip, const Vec3& heading, const DabContext& context)
{
    const double radius = context.dab.radius;
    std::vector<Vec3> around;
    Vec3 sum = Vec3::Zero();
    const auto add = [&](const Vec3& p) {
        const double behind = -(p - tip).dot(heading) / radius;
        if (behind > sectionBegin && behind < sectionEnd) {
            around.push_back(p - tip + behind * radius * heading);
            sum += around.back();
        }
    };
    const bool isOnPlane = context.mirror && context.mirror->imageOf(tip) == tip;
    context.region.forEach([&](Slot v) {
        const Vec3 p = context.mesh().point(v).cast<double>();
        add(p);
        if (isOnPlane && !context.mirror->isOnPlane(v)) // the region has only the half on the positive side
            add(context.mirror->imageOf(p));
    });
    if (around.empty())
        return {};
    const auto count = static_cast<double>(around.size());
    Section section = {tip + sum / count, 0, heading};
    if (isOnPlane)
        section.center = context.mirror->onPlane(section.center);
    for (const Vec3& r : around)
        section.radius += (r - sum / count).norm() / count;
    return section;
}

/// Measures the tip's cross-section. A tip that moves along the mirror plane and reaches it is one with its image, and
/// is measured with it, in the plane.
Section sectionOf(const DabContext& context)
{
    const Dab& dab = context.dab;
    const Section section = sectionAt(dab.position, dab.heading, context);
    const MirrorMap* mirror = context.mirror;
    if (!mirror || std::abs(mirror->height(dab.position)) > capsuleRadius * section.radius ||
        std::abs(mirror->height(dab.heading)) > minTowardsPlane)
        return section;
    return sectionAt(mirror->onPlane(dab.position), mirror->onPlane(dab.heading).normalized(), context);
}

/// The path from the tip into a surface, along the heading.
struct Reach
{
    double gap;   ///< from the section to the surface, mm
    double depth; ///< from the surface to the capsule's end, mm
};

/// Measures the path into the next surface ahead of the tip. Returns nothing unless a surface is within reachDistance
/// of the section's centre and the ray straight ahead meets one within maxGap.
std::optional<Reach> reachOf(const DabContext& context, const Section& section)
{
    const Mesh& mesh = context.mesh();
    Vec3 start = section.center;
    if (context.mirror)
        start += startAside * section.radius * context.mirror->normal();
    const Ray ahead = {start, section.heading};
    const double unreached = std::numeric_limits<double>::infinity();
    double nearest = unreached, gap = unreached;
    std::vector<double> exits; // distances at which the ray leaves the solid, mm
    for (Slot f : Selector(mesh, context.surface.octree()).facesIn({section.center, farthest * section.radius})) {
        const Triangle& t = mesh.corners(f);
        if ((context.mirror && std::ranges::all_of(t, [&](Slot v) { return context.mirror->height(v) <= 0; })) ||
            std::ranges::any_of(t, [&](Slot v) { return context.region.contains(v); }))
            continue;
        const auto point = [&](std::size_t i) { return Vec3(mesh.point(t[i]).cast<double>()); };
        const std::array<Vec3, 3> corners = {point(0), point(1), point(2)};
        if (const double entry = hitTriangle(ahead, corners); entry >= 0)
            gap = std::min(gap, entry);
        if (const double exit = hitTriangle(ahead, {corners[0], corners[2], corners[1]}); exit >= 0)
            exits.push_back(exit);
        const Vec3 way = nearestInTriangle(section.center, corners) - section.center;
        const bool isSeen = way.dot((corners[1] - corners[0]).cross(corners[2] - corners[0])) < 0;
        if (isSeen && way.dot(section.heading) > minAhead * way.norm())
            nearest = std::min(nearest, way.norm());
    }
    if (nearest > reachDistance * section.radius || gap > maxGap * section.radius)
        return std::nullopt;
    double depth = capsuleRadius * section.radius;
    for (const double exit : exits) {
        if (exit > gap)
            depth = std::min(depth, maxDepthShare * (exit - gap));
    }
    return Reach{gap, depth};
}

/// Returns a capsule from the section across the gap into the surface.
PlacedSolid capsuleOver(const Section& section, const Reach& reach)
{
    const Vec3& heading = section.heading;
    TriangleMesh mesh = icosphere(subdivisions, 1);
    std::vector<Vec3> places;
    for (const Vec3f& point : mesh.points) {
        const Vec3 p = point.cast<double>();
        const double along = p.dot(heading);
        const Vec3 across = capsuleRadius * section.radius * (p - along * heading);
        const double shift =
            along > 0 ? reach.gap + reach.depth * along : section.radius * (rearLength * along - overlap);
        places.push_back(section.center + across + shift * heading);
    }
    return PlacedSolid(std::move(mesh), std::move(places), section.center);
}

/// Returns the distance along the heading from the section to the mirror plane, mm; nothing unless the tip is about to
/// reach the plane.
std::optional<double> reachOfPlane(const DabContext& context, const Section& section)
{
    const Vec3 normal = context.mirror->normal();
    const double cosine = -section.heading.dot(normal), height = context.mirror->height(section.center);
    if (cosine < minTowardsPlane)
        return std::nullopt;
    const double lean = capsuleRadius * section.radius *
                        std::sqrt(std::max(1 - cosine * cosine, 0.0)); // of the section's nearest point
    return height > lean && height < lean + reachDistance * section.radius * cosine ? std::optional(height / cosine)
                                                                                    : std::nullopt;
}

/// Returns a tube with round ends from the section to the mirror plane, where it meets its own image. It is made of a
/// sphere: each half becomes a tube, and the circle between them its mitre on the plane.
PlacedSolid tubeToImage(const Section& section, const MirrorMap& mirror)
{
    const Vec3 normal = mirror.normal(), right = normal.unitOrthogonal(), up = normal.cross(right);
    const Vec3 acrossUp = right.cross(section.heading).normalized(), acrossRight = acrossUp.cross(-section.heading);
    TriangleMesh mesh = icosphere(subdivisions, 1);
    std::vector<Vec3> places;
    for (const Vec3f& point : mesh.points) {
        const Vec3 p = point.cast<double>();
        const double behind = std::abs(p.dot(normal)); // the plane at 0, the section at tubeShare, the end at 1
        const double rear = std::max(behind - tubeShare, 0.0) / (1 - tubeShare);
        const Vec3 aside(p.dot(right), p.dot(up), 0);
        const double width =
            aside.isZero(0) ? 0
                            : capsuleRadius * section.radius * std::sqrt(std::max(1 - rear * rear, 0.0)) / aside.norm();
        const Vec3 around = section.center + width * (aside.x() * acrossRight + aside.y() * acrossUp);
        const double toPlane = -around.dot(normal) / section.heading.dot(normal), from = -section.radius * overlap;
        const double along = behind < tubeShare ? toPlane + behind / tubeShare * (from - toPlane)
                                                : from - rearLength * section.radius * rear;
        const Vec3 place = around + along * section.heading;
        places.push_back(behind == 0 ? mirror.onPlane(place) : p.dot(normal) > 0 ? place : mirror.imageOf(place));
    }
    return PlacedSolid(std::move(mesh), std::move(places), mirror.onPlane(section.center));
}

/// Returns the solid that joins the tip to the mirror plane or to a surface, whichever is nearer; nothing if neither is
/// in reach.
std::optional<PlacedSolid> bridgeFrom(const DabContext& context)
{
    const Section section = sectionOf(context);
    if (section.radius == 0)
        return std::nullopt;
    const std::optional<Reach> reach = reachOf(context, section);
    const std::optional<double> plane = context.mirror ? reachOfPlane(context, section) : std::nullopt;
    if (plane && !(reach && reach->gap < *plane))
        return tubeToImage(section, *context.mirror);
    return reach ? std::optional(capsuleOver(section, *reach)) : std::nullopt;
}

/// Rounds the joints by smoothing the vertices that the union has changed, and optimises the mesh there. Leaves the
/// joints sharp if that does not verify.
void smoothJoints(DabContext& context)
{
    const Mesh& mesh = context.mesh();
    const auto smoothed = [&](Slot v) { return Vec3(0.5 * (mesh.point(v).cast<double>() + neighbourMean(mesh, v))); };
    remeshVerified(context, [&] {
        MeshEditor edit = context.editor();
        for (int i = 0; i < smoothings; ++i)
            moveSoundly(edit, context.region, context.bounds, smoothed);
        return optimise(edit, context.region, context.bounds, context.rest());
    });
}
} // namespace

bool joinHookTip(DabContext& context)
{
    const Dab& dab = context.dab;
    if (context.settings.tool != Tool::SnakeHook || !context.settings.fusion || dab.way < minWay * dab.radius)
        return false;
    std::optional<PlacedSolid> bridge = bridgeFrom(context);
    if (!bridge || applyBoolean(context, std::move(*bridge), BooleanOperation::Unite) != BooleanOutcome::Done)
        return false;
    if (context.settings.topology != Topology::Keep) {
        smoothJoints(context);
        splitVerified(context);
    }
    context.report.outcome = DabOutcome::Committed;
    context.report.touchedVertices = context.touchedVertices();
    context.request.isOver = true;
    return true;
}
} // namespace core
