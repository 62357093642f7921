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
/// The shortest way of a tip that joins, in radii: before that it is among what lies around its root.
constexpr double minWay = 1;
/// The least distance of a tip that joins from its mirror image, in radii: nearer ones are selected by halves.
constexpr double minApart = 2;
/// The range of distances behind the tip, in radii, from which its section is measured.
constexpr double sectionBegin = 0.05, sectionEnd = 0.35;
/// The largest distance of a surface that is reached, before the rim of the tip meets it, and the largest gap ahead of
/// the tip. In radii of the section.
constexpr double reachDistance = 1.3, maxGap = 4;
/// The least cosine of the angle between the heading and the way to a surface that is reached.
constexpr double minAhead = 0.2;
/// The capsule's radius, the length of its rear, and how far its sides begin behind the tip, in radii of the section.
/// It is a little wider than the section and narrows soon behind it, so their surfaces cross in one ring.
constexpr double capsuleRadius = 1.03, rearLength = 0.5, overlap = 0.15;
/// The largest share of a wall's thickness that the capsule goes in.
constexpr double maxDepthShare = 0.5;
/// Subdivisions of the capsule's ball: its edges are 0.13 to 0.16 radii long.
constexpr int subdivisions = 3;
constexpr int smoothings = 3;

/// A section of the tentacle, across its way behind the tip.
struct Section
{
    Vec3 center = Vec3::Zero(); ///< in the plane through the tip, in mm
    double radius = 0;          ///< the mean, in mm; 0: nothing lies behind the tip
};

/// Measures the section at the tip.
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

/// The way from the tip into a surface, along the heading, in mm.
struct Reach
{
    double gap;   ///< from the section to the surface
    double depth; ///< from there to the capsule's end
};

/// Measures the way into the next surface ahead of the tip. Returns nothing if the section's rim does not meet it soon.
std::optional<Reach> reachOf(const DabContext& context, const Section& section)
{
    const Mesh& mesh = context.mesh();
    const Ray ahead = {section.center, context.dab.heading};
    const double unreached = std::numeric_limits<double>::infinity(), farthest = (maxGap + 2) * section.radius;
    double nearest = unreached, gap = unreached;
    std::vector<double> exits; // through faces that look away from the tip
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

/// Returns a capsule from the section over the gap into the surface.
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

/// Makes the joints round, by smoothing what the union has changed, and optimises them. Leaves them sharp if that is
/// not sound.
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
    context.request.hasLetGo = true;
    return true;
}
} // namespace core
