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
/// Displacement at the centre of Pull and Push at strength 1, and step of Clay and Layer, in radii. The paper (section
/// 3.3) has eps = +-1 and leaves its length open.
constexpr double peakPerRadius = 0.1;
/// Inflate's peak as a fraction of Pull's. Smaller, because displacement along converging normals soon makes the
/// surface intersect itself.
constexpr double swellPerPeak = 0.6;
/// Shares of a vertex's distance from the line by which Pinch and Crease move it at strength 1, and the largest share
/// at any strength.
constexpr double pinchShare = 0.1, creasePinchShare = 0.25, maxPinched = 0.5;
/// Depth of the groove that a dab of Crease cuts at strength 1, in radii.
constexpr double creaseDepth = 0.05;
/// Smallest divisor 1 + cos a in hook(), for a dab of Snake Hook whose heading turns by the angle a. Beyond a right
/// angle the dab turns by less than a.
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

/// The input of a displacement field.
struct FieldInput : DeformInput
{
    const Region& region;

    /// Returns the displacement at the dab's centre, in mm.
    double peak() const { return peakPerRadius * dab.radius * dab.strength; }
    /// Returns the share of the distance to the field's target that a vertex moves, at most 1.
    double share() const { return std::min(dab.strength, 1.0); }
    double sign() const { return settings.inverted ? -1 : 1; }
    Vec3 point(Slot v) const { return mesh.point(v).cast<double>(); }
};

/// The region's mean plane: its mean point and mean normal, P_center and N_avg of the paper (section 3.3).
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

/// Returns a function that returns the offset of a vertex from the line through the dab's centre along its motion,
/// within the surface's mean plane. If the dab has no motion, the offset is from the centre. Keeps a reference to `d`.
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

/// Returns the field of Pull and Push: D(r_i) = eps b(r_i/R) N_i (paper, section 3.3). `length`: eps, in mm; negative
/// for Push. The weight w is b(r_i/R), times the alpha's shade.
Field pull(const FieldInput& d, double length)
{
    return [&d, length](Slot v, double w) -> Vec3 { return length * w * unitNormal(d.mesh, v); };
}

/// Returns the field of Inflate: +-0.06 R s w (2 - w) n_i, where R is the radius and s the strength. Its profile is
/// fuller than Pull's, and its peak lower.
Field inflate(const FieldInput& d)
{
    return [&d, length = d.sign() * swellPerPeak * d.peak()](Slot v, double w) -> Vec3 {
        return length * w * (2 - w) * unitNormal(d.mesh, v);
    };
}

/// Returns the field of Clay. Moves vertices by at most two peaks towards the mean plane raised by one peak, as the
/// clay brushes of SculptGL and Blender do. Vertices above the raised plane stay. Inverted, it digs.
Field clay(const FieldInput& d)
{
    const Plane plane = meanPlane(d);
    return [&d, plane, up = d.sign(), h = d.peak()](Slot v, double w) -> Vec3 {
        return w * up * std::clamp(h - up * plane.height(d.point(v)), 0.0, 2 * h) * plane.normal;
    };
}

/// Returns the field of Layer: n_i h min(1, sum w) over the surface before the stroke, where n_i are the normals before
/// the stroke and h is the peak.
Field layer(const FieldInput& d)
{
    return [&d, up = d.sign(), h = d.peak()](Slot v, double w) -> Vec3 {
        const Vec3 normal = d.displacements.normalAtRest(v, d.mesh);
        const double raised = up * d.displacements.of(v).value_or(Vec3::Zero()).dot(normal);
        return up * std::clamp(h - raised, 0.0, w * h) * normal;
    };
}

/// Returns the field of Flatten: -s w ((p_i - P_center) . N_avg) N_avg (paper, section 3.3), onto the plane of P_center
/// and N_avg.
Field flatten(const FieldInput& d)
{
    return [&d, plane = meanPlane(d), s = d.share()](Slot v, double w) -> Vec3 {
        return -s * w * Vec3(plane.height(d.point(v)) * plane.normal);
    };
}

/// Returns the field of Scrape: flattens only vertices above the mean plane; inverted, only those below it.
Field scrape(const FieldInput& d)
{
    return [&d, plane = meanPlane(d), up = d.sign(), s = d.share()](Slot v, double w) -> Vec3 {
        return -s * w * up * std::max(up * plane.height(d.point(v)), 0.0) * plane.normal;
    };
}

/// Returns the field of Smooth, the Laplacian with uniform weights (paper, section 3.3): s w (mean of the neighbours -
/// p_i).
Field smooth(const FieldInput& d)
{
    return [&d, s = d.share()](Slot v, double w) -> Vec3 { return s * w * (neighbourMean(d.mesh, v) - d.point(v)); };
}

/// Returns the field of Pinch. Moves vertices within the mean plane towards the line of the dab's motion; inverted,
/// away from it.
Field pinch(const FieldInput& d)
{
    const double share = d.sign() * std::min(pinchShare * d.dab.strength, maxPinched);
    return [across = acrossLine(d, meanNormal(d.region, d.mesh)), share](Slot v, double w) -> Vec3 {
        return -share * w * across(v);
    };
}

/// Returns the field of Crease. Pinches, and cuts a V-shaped groove with the profile (1 - x)^4, where x is the distance
/// from the line in radii. Inverted, it raises a ridge. Steep walls are pinched less: otherwise they close to a slit,
/// whose bottom wanders sideways.
Field crease(const FieldInput& d)
{
    const Vec3 normal = meanNormal(d.region, d.mesh);
    const double share = std::min(creasePinchShare * d.dab.strength, maxPinched);
    const double depth = d.sign() * creaseDepth * d.dab.radius * d.dab.strength;
    return [&d, across = acrossLine(d, normal), normal, share, depth](Slot v, double w) -> Vec3 {
        const Vec3 r = across(v);
        const double inside = 1 - std::min(r.norm() / d.dab.radius, 1.0), inside2 = inside * inside;
        const double levelness = std::max(unitNormal(d.mesh, v).dot(normal), 0.0);
        return -share * w * levelness * r - depth * w * inside2 * inside2 * normal;
    };
}

/// Returns the field of Grab: s w times the dab's motion.
Field follow(const FieldInput& d)
{
    return [way = Vec3(d.share() * d.dab.motion)](Slot, double w) -> Vec3 { return w * way; };
}

/// Returns the field of Snake Hook. Moves vertices by the dab's motion and turns them about the dab's centre as its
/// heading turns, so that a tentacle stays round in a bend. A vertex that turns by a share of the angle a uses
/// that share of tan(a/2), which is only approximate.
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

/// Returns the field of Twist. Turns vertices about the axis through the dab's centre, by the angle s w turn. The
/// quaternion uses a/2 in place of tan(a/2), which differs little for the turn of one dab and gives the same bits on
/// every machine.
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

/// Returns the field of Stamp. Moves vertices onto the stamp's shape (StampShape); vertices on its outline stay. With
/// Topology::Keep the outline is not cut into the mesh. Instead the field is averaged over a square as wide as the
/// longest edge at a vertex.
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
    const DabWeights weights(region, mesh, input.settings, input.dab, input.moved);
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
