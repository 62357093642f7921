#include "core/sculpt/hook_tip.h"

#include "core/geometry/point_triangle.h"
#include "core/mesh/normals.h"
#include "core/sculpt/boolean_dab.h"
#include "core/sculpt/remesh/remesh.h"
#include "core/sculpt/select/selector.h"
#include "core/sculpt/verify/mesh_transaction.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace core
{
namespace
{
/// With a mirror the tip joins nothing whose image is nearer than that, in radii: half of it is selected.
constexpr double minApart = 2;
/// The tip joins nothing before it has come so far, in radii: at first it stands among what lies around.
constexpr double minWay = 1;
/// What belongs to the section at the tip: its distance behind the tip, in radii of the brush.
constexpr double sectionBegin = 0.05, sectionEnd = 0.35;
/// In radii of the section: the distance at which another surface is reached, before the rim of the tip meets it, and
/// how far ahead it may lie. The least cosine of the angle between the heading and the way to it.
constexpr double reachDistance = 1.3, maxGap = 4, minAhead = 0.2;
/// The capsule is a little wider than the section, and behind the tip narrows soon: so their surfaces cross in one
/// ring.
constexpr double capsuleRadius = 1.03, rearLength = 0.5, overlap = 0.15;
/// Edges of 0.13 to 0.16 radii of the capsule.
constexpr int subdivisions = 3;
constexpr int smoothings = 3;

/// The section of what was drawn out, across its way behind the tip.
struct Section
{
    Vec3 center = Vec3::Zero(); ///< on the plane through the tip
    double radius = 0;          ///< the mean; 0: nothing lies behind the tip
};

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

/// Returns how far the next surface lies ahead of the tip, if the section's rim is about to meet it.
std::optional<double> gapAhead(const DabContext& context, const Section& section)
{
    const Mesh& mesh = context.mesh();
    const Dab& dab = context.dab;
    double nearest = std::numeric_limits<double>::infinity(), gap = nearest;
    for (Slot f : Selector(mesh, context.surface.octree()).facesIn({section.center, maxGap * section.radius})) {
        const Triangle& t = mesh.corners(f);
        if (std::ranges::any_of(t, [&](Slot v) { return context.region.contains(v); }))
            continue;
        const auto point = [&](std::size_t i) { return Vec3(mesh.point(t[i]).cast<double>()); };
        const std::array<Vec3, 3> corners = {point(0), point(1), point(2)};
        const double ahead = hitTriangle({section.center, dab.heading}, corners);
        gap = ahead >= 0 ? std::min(gap, ahead) : gap;
        const Vec3 way = nearestInTriangle(section.center, corners) - section.center;
        const bool isSeen = way.dot((corners[1] - corners[0]).cross(corners[2] - corners[0])) < 0;
        if (isSeen && way.dot(dab.heading) > minAhead * way.norm())
            nearest = std::min(nearest, way.norm());
    }
    const bool isReached = nearest <= reachDistance * section.radius && gap <= maxGap * section.radius;
    return isReached ? std::optional(gap) : std::nullopt;
}

/// Returns a capsule from the section over the gap.
PlacedSolid capsuleOver(const Section& section, const Vec3& heading, double gap)
{
    TriangleMesh mesh = icosphere(subdivisions, 1);
    std::vector<Vec3> places;
    for (const Vec3f& point : mesh.points) {
        const Vec3 p = point.cast<double>();
        const double along = p.dot(heading);
        const Vec3 across = p - along * heading;
        const double shift = along > 0 ? capsuleRadius * along : rearLength * along;
        places.push_back(section.center + section.radius * (capsuleRadius * across + (shift - overlap) * heading) +
                         (along > 0 ? gap + overlap * section.radius : 0) * heading);
    }
    return PlacedSolid(std::move(mesh), std::move(places), section.center);
}

/// Smooths what the union has changed: the joints become round.
void smoothJoints(DabContext& context)
{
    MeshTransaction transaction(context.surface, context.region);
    const Mesh& mesh = context.mesh();
    const auto smoothed = [&](Slot v) { return Vec3(0.5 * (mesh.point(v).cast<double>() + neighbourMean(mesh, v))); };
    MeshEditor edit = context.editor();
    for (int i = 0; i < smoothings; ++i)
        moveSoundly(edit, context.region, context.bounds, smoothed);
    transaction.commit();
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
    const std::optional<double> gap = section.radius > 0 ? gapAhead(context, section) : std::nullopt;
    if (!gap || uniteOnBothSides(context, capsuleOver(section, dab.heading, *gap)) != BooleanOutcome::Done)
        return false;
    smoothJoints(context);
    context.report.outcome = DabOutcome::Committed;
    context.report.touchedVertices = context.touchedVertices();
    context.request.hasLetGo = true;
    return true;
}
} // namespace core
