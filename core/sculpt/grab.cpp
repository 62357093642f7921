#include "core/sculpt/grab.h"

#include "core/sculpt/dab_bounds.h"
#include "core/sculpt/deform/deform.h"
#include "core/sculpt/deform/grab_push.h"

#include <algorithm>

namespace core
{
namespace
{
/// Two dabs move in the same direction if the cosine of the angle between their motions is at least this.
constexpr double sameWay = 0.9;

Vec3 wayOf(const Dab& dab)
{
    return dab.turn != 0 ? Vec3(dab.turn * dab.axis) : dab.motion;
}

/// Returns the mean length of the edges within the region, in mm; 0 if it has none.
double meanEdge(const Region& region, const Mesh& mesh)
{
    double sum = 0;
    int n = 0;
    region.forEach([&](Slot v) {
        mesh.forEachOutgoing(v, [&](Slot h) {
            if (const Slot other = mesh.to(h); other > v && region.contains(other)) {
                sum += (mesh.point(other) - mesh.point(v)).cast<double>().norm();
                ++n;
            }
        });
    });
    return n > 0 ? sum / n : 0;
}
} // namespace

void Grab::measure(const Mesh& mesh)
{
    state = {};
    state.axis = meanNormal(region, mesh);
    state.detail = detailPerMeanEdge * meanEdge(region, mesh);
}

void Grab::keep(const Mesh& mesh, bool isHalf, const Vec3& motion)
{
    state = {true, isHalf, state.axis, state.moved + motion, state.detail, mesh.removedVertices().size()};
}

void Grab::grow(const StrokeSettings& settings, const Mesh& mesh, const Dab& dab)
{
    if (settings.falloff == 0) // without falloff every vertex of the region has weight 1
        return;
    const EdgeBounds brushBounds = dabBounds(settings, mesh, dab.radius);
    const double detail = state.limits.inUse() ? brushBounds.detail : bounds(settings, mesh, brushBounds).detail;
    std::vector<Slot> rim;
    region.forEach([&](Slot v) {
        if (region.distance(v) >= dab.radius && !(state.isHalf && region.carried(v) < dab.radius))
            return; // this vertex was added by grow() itself
        mesh.forEachOutgoing(v, [&](Slot h) {
            const Slot other = mesh.to(h);
            if (!region.contains(other) &&
                (mesh.point(other) - mesh.point(v)).cast<double>().squaredNorm() > detail * detail)
                rim.push_back(other);
        });
    });
    for (Slot v : rim)
        region.add(v, dab.radius, Vec3::Zero(), 2 * dab.radius);
    if (settings.tool == Tool::Grab && !state.moved.isZero(0))
        growPushed(settings, mesh, dab, detail);
}

/// Adds the vertices that the dab pushes, as far as edges connect them with the part that the hand holds, and the
/// vertices at the far ends of edges longer than `detail`, mm.
void Grab::growPushed(const StrokeSettings& settings, const Mesh& mesh, const Dab& dab, double detail)
{
    const GrabPush push(region, mesh, settings, dab, state.moved);
    SlotSet part = push.held();
    for (std::size_t i = 0; i < part.size(); ++i) { // the set grows during the loop
        const Vec3 place = mesh.point(part.slots()[i]).cast<double>();
        const double weight = weightAt(region.distance(part.slots()[i]), settings, dab);
        if (push.at(place, weight) == 0)
            continue;
        mesh.forEachOutgoing(part.slots()[i], [&](Slot h) {
            const Slot v = mesh.to(h);
            const Vec3 end = mesh.point(v).cast<double>();
            if (region.contains(v) || (push.at(end, 0) == 0 && (end - place).squaredNorm() <= detail * detail))
                return;
            region.add(v, dab.radius, Vec3::Zero(), dab.radius); // its image may be pushed, too
            part.add(v);
        });
    }
}

void Grab::dropRemoved(const Mesh& mesh)
{
    const std::vector<Slot>& removed = mesh.removedVertices();
    for (; state.known < removed.size(); ++state.known) {
        if (const Slot v = removed[state.known]; region.contains(v))
            region.remove(v);
    }
}

std::vector<Slot> Grab::faces(const Mesh& mesh)
{
    SlotSet& faces = region.scratch();
    faces.clear();
    region.forEach([&](Slot v) { mesh.forEachOutgoing(v, [&](Slot h) { faces.add(mesh.face(h)); }); });
    faces.sort();
    return faces.slots();
}

Sphere Grab::ball(const Mesh& mesh) const
{
    Box box;
    region.forEach([&](Slot v) { box.extend(mesh.point(v).cast<double>()); });
    return {box.center(), 0.5 * box.diagonal().norm()};
}

EdgeBounds Grab::bounds(const StrokeSettings& settings, const Mesh& mesh, const EdgeBounds& bounds) const
{
    if (!keepsSelection(settings.tool) || settings.topology == Topology::Uniform || !(state.detail > 0))
        return bounds;
    return edgeBounds(std::clamp(state.detail, mesh.lattice().minDetail(), bounds.detail));
}

bool Grab::isLimitedFor(const Dab& dab) const
{
    const Vec3 way = wayOf(dab);
    return state.limits.inUse() && way.dot(state.way) >= sameWay * way.norm() * state.way.norm();
}

void Grab::noteLimits(const Dab& dab, MotionLimits limits, unsigned fallbackSteps)
{
    state.way = wayOf(dab);
    state.limits = std::move(limits);
    state.fallbackSteps = fallbackSteps;
}
} // namespace core
