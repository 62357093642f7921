#include "core/sculpt/deform/deform.h"

#include "core/mesh/normals.h"
#include "core/sculpt/deform/dab_weights.h"
#include "core/util/parallel.h"

#include <algorithm>
#include <cassert>
#include <functional>

namespace core
{
namespace
{
/// The peak of Pull and Push at strength 1, in radii, and the step of Clay and Layer. Our choice: the paper (section
/// 3.3) has eps = +-1 and leaves the length open.
constexpr double peakPerRadius = 0.1;
/// Factor of the peak for Inflate: vertices that move along converging normals soon fold the surface up.
constexpr double swellPerPeak = 0.6;
/// The share of a vertex's distance from the line by which Pinch and Crease move it at strength 1, and the largest one.
constexpr double pinchShare = 0.1, creasePinchShare = 0.25, maxPinched = 0.5;
/// The depth that a dab of Crease cuts at strength 1, in radii.
constexpr double creaseDepth = 0.05;
/// The least divisor 1 + cos a for a dab of Snake Hook whose way turns by a: beyond a right angle it turns by less.
constexpr double minTurnDivisor = 1;
constexpr std::size_t plannedPerChunk = 256;

Vec3 unitNormal(const Mesh& mesh, Slot v)
{
    const Vec3 normal = vertexNormal(mesh, v);
    const double length = normal.norm();
    return length > 0 ? Vec3(normal / length) : Vec3::Zero();
}

/// A deformation field: returns the displacement, in mm, of a vertex that has this weight.
using Field = std::function<Vec3(Slot v, double weight)>;

/// The input of a field.
struct FieldInput : DeformInput
{
    const Region& region;

    /// Returns the peak of the dab, in mm.
    double peak() const { return peakPerRadius * dab.radius * dab.strength; }
    /// Returns the share of its way that a vertex moves towards the target of a field, at most 1.
    double share() const { return std::min(dab.strength, 1.0); }
    double sign() const { return settings.inverted ? -1 : 1; }
    Vec3 point(Slot v) const { return mesh.point(v).cast<double>(); }
};

/// P_center and N_avg (paper, section 3.3): the region's mean point and mean normal.
struct Plane
{
    Vec3 center, normal;

    double height(const Vec3& p) const { return (p - center).dot(normal); }
};

Plane meanPlane(const FieldInput& d)
{
    Vec3 center = Vec3::Zero();
    d.region.forEach([&](Slot v) { center += d.point(v); });
    return {center / d.region.size(), meanNormal(d.region, d.mesh)};
}

/// Returns a function that gives a vertex's offset from the line through the dab's centre along its motion, within the
/// surface's mean plane. A dab without motion has its centre for a line. Refers to `d`.
std::function<Vec3(Slot)> acrossLine(const FieldInput& d, const Vec3& normal)
{
    Vec3 way = d.dab.motion - d.dab.motion.dot(normal) * normal;
    const double length = way.norm();
    way = length > 0 ? Vec3(way / length) : Vec3::Zero();
    return [&d, normal, way](Slot v) -> Vec3 {
        const Vec3 r = d.point(v) - d.dab.position;
        return r - r.dot(normal) * normal - r.dot(way) * way;
    };
}

/// D(r_i) = eps b(r_i/R) N_i (paper, section 3.3). `length`: eps, in mm; negative for Push. w is b(r_i/R), times the
/// alpha.
Field pull(const FieldInput& d, double length)
{
    return [&d, length](Slot v, double w) -> Vec3 { return length * w * unitNormal(d.mesh, v); };
}

/// Inflates: +-0.06 R s w (2 - w) n_i. Its profile is fuller than Pull's, and its peak lower.
Field inflate(const FieldInput& d)
{
    return [&d, length = d.sign() * swellPerPeak * d.peak()](Slot v, double w) -> Vec3 {
        return length * w * (2 - w) * unitNormal(d.mesh, v);
    };
}

/// Moves vertices towards the mean plane raised by one peak, as the clay brushes of SculptGL and Blender do, by two
/// peaks at most. Vertices above that plane stay. Inverted it digs.
Field clay(const FieldInput& d)
{
    const Plane plane = meanPlane(d);
    return [&d, plane, up = d.sign(), h = d.peak()](Slot v, double w) -> Vec3 {
        return w * up * std::clamp(h - up * plane.height(d.point(v)), 0.0, 2 * h) * plane.normal;
    };
}

/// Raises a layer: n_i h min(1, sum w) over the surface at the beginning of the stroke, with its normals n_i and the
/// peak for h.
Field layer(const FieldInput& d)
{
    return [&d, up = d.sign(), h = d.peak()](Slot v, double w) -> Vec3 {
        const Vec3 normal = d.displacements.normalAtRest(v, d.mesh);
        const double raised = up * d.displacements.of(v).value_or(Vec3::Zero()).dot(normal);
        return up * std::clamp(h - raised, 0.0, w * h) * normal;
    };
}

/// Flattens onto the plane of P_center and N_avg (paper, section 3.3): -s w ((p_i - P_center) . N_avg) N_avg.
Field flatten(const FieldInput& d)
{
    return [&d, plane = meanPlane(d), s = d.share()](Slot v, double w) -> Vec3 {
        return -s * w * Vec3(plane.height(d.point(v)) * plane.normal);
    };
}

/// Flattens only vertices above the mean plane; inverted, only those below it.
Field scrape(const FieldInput& d)
{
    return [&d, plane = meanPlane(d), up = d.sign(), s = d.share()](Slot v, double w) -> Vec3 {
        return -s * w * up * std::max(up * plane.height(d.point(v)), 0.0) * plane.normal;
    };
}

/// Smooths by the Laplacian of uniform weights (paper, section 3.3): s w (mean of the neighbours - p_i).
Field smooth(const FieldInput& d)
{
    return [&d, s = d.share()](Slot v, double w) -> Vec3 { return s * w * (neighbourMean(d.mesh, v) - d.point(v)); };
}

/// Moves vertices along the mean plane towards the line; inverted, away from it.
Field pinch(const FieldInput& d)
{
    const double share = d.sign() * std::min(pinchShare * d.dab.strength, maxPinched);
    return [across = acrossLine(d, meanNormal(d.region, d.mesh)), share](Slot v, double w) -> Vec3 {
        return -share * w * across(v);
    };
}

/// Pinches, and cuts in with a V for a profile: (1 - x)^4 of the distance x from the line, in radii. Inverted it raises
/// a ridge.
Field crease(const FieldInput& d)
{
    const Vec3 normal = meanNormal(d.region, d.mesh);
    const double share = std::min(creasePinchShare * d.dab.strength, maxPinched);
    const double depth = d.sign() * creaseDepth * d.dab.radius * d.dab.strength;
    return [&d, across = acrossLine(d, normal), normal, share, depth](Slot v, double w) -> Vec3 {
        const Vec3 r = across(v);
        const double inside = 1 - std::min(r.norm() / d.dab.radius, 1.0), inside2 = inside * inside;
        return -share * w * r - depth * w * inside2 * inside2 * normal;
    };
}

/// Moves vertices with the hand: s w times the dab's motion.
Field follow(const FieldInput& d)
{
    return [way = Vec3(d.share() * d.dab.motion)](Slot, double w) -> Vec3 { return w * way; };
}

/// Moves vertices with the hand, and turns them about the dab's centre as its way turns, so that a tentacle stays round
/// in a bend. The quaternion takes a share of tan(a/2) for that of an angle a.
Field hook(const FieldInput& d)
{
    const Vec3 before = d.dab.heading, after = headingAfter(d.dab);
    const Vec3 half = before.isZero(0) ? Vec3(Vec3::Zero())
                                       : Vec3(before.cross(after) / std::max(1 + before.dot(after), minTurnDivisor));
    return [&d, half, share = d.share()](Slot v, double w) -> Vec3 {
        const Vec3 turned = share * w * half, r = d.point(v) - d.dab.position;
        return share * w * d.dab.motion + Eigen::Quaterniond(1, turned.x(), turned.y(), turned.z()).normalized() * r -
               r;
    };
}

/// Turns vertices about the axis through the dab's centre, by the angle s w turn. The quaternion takes a/2 for
/// tan(a/2), which differs little for the turn of one dab and gives the same bits on every machine.
Field twist(const FieldInput& d)
{
    return [&d, half = 0.5 * d.share() * d.dab.turn](Slot v, double w) -> Vec3 {
        const Vec3 turned = half * w * d.dab.axis, r = d.point(v) - d.dab.position;
        return Eigen::Quaterniond(1, turned.x(), turned.y(), turned.z()).normalized() * r - r;
    };
}

double longestEdge(const Mesh& mesh, Slot v)
{
    double longest2 = 0;
    mesh.forEachOutgoing(v, [&](Slot h) {
        longest2 = std::max(longest2, (mesh.point(mesh.to(h)) - mesh.point(v)).cast<double>().squaredNorm());
    });
    return std::sqrt(longest2);
}

/// Moves vertices to the surface of the stamp (StampShape); those on its outline stay. Where the mesh is kept, and so
/// was not cut along the outline, smooths that over a square as wide as the longest edge at a vertex.
Field stamp(const FieldInput& d)
{
    const bool isCut = d.settings.topology != Topology::Keep;
    return [&d, isCut, stamp = StampShape(frameOn(d.region, d.mesh, d.settings, d.dab), d.settings, d.dab)](
               Slot v, double) -> Vec3 {
        if (d.region.carried(v) != 0)
            return Vec3::Zero();
        return stamp.field(d.point(v), isCut ? 0 : 0.5 * longestEdge(d.mesh, v));
    };
}

Field fieldOf(const FieldInput& d)
{
    switch (d.settings.tool) {
    case Tool::Pull:
        return pull(d, d.peak());
    case Tool::Push:
        return pull(d, -d.peak());
    case Tool::Inflate:
        return inflate(d);
    case Tool::Clay:
        return clay(d);
    case Tool::Layer:
        return layer(d);
    case Tool::Flatten:
        return flatten(d);
    case Tool::Scrape:
        return scrape(d);
    case Tool::Smooth:
        return smooth(d);
    case Tool::Pinch:
        return pinch(d);
    case Tool::Crease:
        return crease(d);
    case Tool::Grab:
        return follow(d);
    case Tool::SnakeHook:
        return hook(d);
    case Tool::Twist:
        return twist(d);
    case Tool::Stamp:
        return stamp(d);
    case Tool::Paint:
    case Tool::Mask:
        break;
    }
    assert(false && "these move nothing");
    return [](Slot, double) -> Vec3 { return Vec3::Zero(); };
}
} // namespace

double weightAt(double distance, const StrokeSettings& settings, const Dab& dab)
{
    const double x = std::min(distance / dab.radius, 1.0), inner = coreShare(settings.tool);
    return falloff(std::max(x - inner, 0.0) / (1 - inner), settings.falloff);
}

Vec3 meanNormal(const Region& region, const Mesh& mesh)
{
    Vec3 normal = Vec3::Zero();
    region.forEach([&](Slot v) { normal += unitNormal(mesh, v); });
    const double length = normal.norm();
    return length > 0 ? Vec3(normal / length) : Vec3::Zero();
}

double planDeformation(Region& region, const DeformInput& input)
{
    const Mesh& mesh = input.mesh;
    const FieldInput fieldInput = {input, region};
    const Field field = fieldOf(fieldInput);
    const DabWeights weights(region, mesh, input.settings, input.dab);
    const std::vector<Slot>& slots = region.slots();
    std::vector<double> longest2(1 + chunksOf(slots.size(), plannedPerChunk), 0.0);
    forEachChunk(slots.size(), plannedPerChunk, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const Slot v = slots[i];
            if (!region.contains(v))
                continue;
            const Vec3 plan = mesh.freedom(v) * field(v, weights.of(v));
            region.setPlan(v, plan);
            longest2[chunk] = std::max(longest2[chunk], plan.squaredNorm());
        }
    });
    return std::sqrt(*std::ranges::max_element(longest2));
}

void smoothPlan(Region& region, const Mesh& mesh, std::span<const Slot> vertices)
{
    std::vector<std::pair<Slot, Vec3>> smoothed;
    for (Slot v : withNeighbours(region, mesh, vertices)) {
        const Vec3 plan = region.plan(v);
        Vec3 sum = plan;
        mesh.forEachOutgoing(v, [&](Slot h) {
            if (region.contains(mesh.to(h)))
                sum += region.plan(mesh.to(h));
        });
        const double length = sum.norm();
        if (length > 0)
            smoothed.emplace_back(v, plan.norm() / length * sum);
    }
    for (const auto& [v, plan] : smoothed)
        region.setPlan(v, plan);
}
} // namespace core
