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
/// A tip nearer than this (in radii) to its mirror image is not joined, because the region then contains only one half
/// of the tip.
constexpr double minApart = 2;
/// Range of distances behind the tip, in radii, within which vertices are used to measure its cross-section.
constexpr double sectionBegin = 0.05, sectionEnd = 0.35;
/// Largest distance from the section's centre to a surface in reach, and to the first surface straight ahead, both in
/// radii of the section.
/// reachDistance is more than 1, so that the union comes before the rim of the tip touches the surface.
constexpr double reachDistance = 1.3, maxGap = 4;
/// Smallest cosine of the angle between the heading and the direction to a surface in reach.
constexpr double minAhead = 0.2;
/// The capsule's radius, the length of its rear cap, and how far its sides start behind the tip, all in radii of the
/// section. The capsule is slightly wider than the section and narrows just behind it, so that the two surfaces cross
/// in a single closed curve.
constexpr double capsuleRadius = 1.03, rearLength = 0.5, overlap = 0.15;
/// Largest depth of the capsule in the reached surface, as a share of the wall's thickness.
constexpr double maxDepthShare = 0.5;
/// Subdivisions of the icosahedron that the capsule is made of: edges of 0.13 to 0.16 radii.
constexpr int subdivisions = 3;
constexpr int smoothings = 3;

/// A cross-section of the tentacle, just behind its tip.
struct Section
{
    Vec3 center = Vec3::Zero(); ///< centre, mm; in the plane through the tip
    double radius = 0;          ///< mean radius, mm; 0 if there are no vertices behind the tip
};

/// Measures the cross-section at the tip.
Section sectionOf(const DabContext& context)
{
    const Dab& dab = context.dab;
    std::vector<Vec3> around;
    Vec3 sum = Vec3::Zero();
    context.region.forEach([&](Slot v) {
        const Vec3 r = context.mesh().point(v).cast<double>() - dab.position;
        const double behind = -r.dot(dab.heading) / dab.radius;
        if (behind > sectionBegin && behind < sectionEnd) {
            around.push_back(r + behind * dab.radius * dab.heading);
            sum += around.back();
        }
    });
    if (around.empty())
        return {};
    const auto count = static_cast<double>(around.size());
    Section section = {dab.position + sum / count, 0};
    for (const Vec3& r : around)
        section.radius += (r - sum / count).norm() / count;
    return section;
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
    const Ray ahead = {section.center, context.dab.heading};
    const double unreached = std::numeric_limits<double>::infinity(), farthest = (maxGap + 2) * section.radius;
    double nearest = unreached, gap = unreached;
    std::vector<double> exits; // distances at which the ray leaves the solid, mm
    for (Slot f : Selector(mesh, context.surface.octree()).facesIn({section.center, farthest})) {
        const Triangle& t = mesh.corners(f);
        if (std::ranges::any_of(t, [&](Slot v) { return context.region.contains(v); }))
            continue;
        const auto point = [&](std::size_t i) { return Vec3(mesh.point(t[i]).cast<double>()); };
        const std::array<Vec3, 3> corners = {point(0), point(1), point(2)};
        if (const double entry = hitTriangle(ahead, corners); entry >= 0)
            gap = std::min(gap, entry);
        if (const double exit = hitTriangle(ahead, {corners[0], corners[2], corners[1]}); exit >= 0)
            exits.push_back(exit);
        const Vec3 way = nearestInTriangle(section.center, corners) - section.center;
        const bool isSeen = way.dot((corners[1] - corners[0]).cross(corners[2] - corners[0])) < 0;
        if (isSeen && way.dot(context.dab.heading) > minAhead * way.norm())
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
PlacedSolid capsuleOver(const Section& section, const Vec3& heading, const Reach& reach)
{
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
    if (context.mirror && (context.mirror->imageOf(dab.position) - dab.position).norm() < minApart * dab.radius)
        return false;
    const Section section = sectionOf(context);
    const std::optional<Reach> reach = section.radius > 0 ? reachOf(context, section) : std::nullopt;
    if (!reach || uniteOnBothSides(context, capsuleOver(section, dab.heading, *reach)) != BooleanOutcome::Done)
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
