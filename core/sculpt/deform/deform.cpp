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
/// At strength 1 the peak of Pull and Push is this part of the radius (paper, section 3.3), and so are the steps of
/// Clay and Layer.
constexpr double peakPerRadius = 0.1;
/// Of Inflate, in terms of that: what moves along normals that run together soon folds up.
constexpr double swellPerPeak = 0.6;
/// At strength 1 a dab draws what is around a line this share nearer to it, and never all the way.
constexpr double pinchShare = 0.1, creasePinchShare = 0.25, maxPinched = 0.5;
/// At strength 1 a dab of Crease cuts so deep, in radii.
constexpr double creaseDepth = 0.05;
constexpr std::size_t plannedPerChunk = 256;

Vec3 unitNormal(const Mesh& mesh, Slot v)
{
    const Vec3 normal = vertexNormal(mesh, v);
    const double length = normal.norm();
    return length > 0 ? Vec3(normal / length) : Vec3::Zero();
}

/// The displacement of a vertex whose weight is that.
using Field = std::function<Vec3(Slot v, double weight)>;

/// What fields are made of.
struct Dabbed
{
    const Region& region;
    const Mesh& mesh;
    const StrokeSettings& settings;
    const Dab& dab;

    double peak() const { return peakPerRadius * dab.radius * dab.strength; }
    /// Of a field that takes vertices to a place: all the way at most.
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

Plane meanPlane(const Dabbed& d)
{
    Vec3 center = Vec3::Zero();
    d.region.forEach([&](Slot v) { center += d.point(v); });
    return {center / d.region.size(), meanNormal(d.region, d.mesh)};
}

/// From the line through the dab's centre along its way, in the surface's mean plane; a dab that has not come from
/// anywhere has a point for a line.
std::function<Vec3(Slot)> acrossLine(const Dabbed& d, const Vec3& normal)
{
    Vec3 way = d.dab.motion - d.dab.motion.dot(normal) * normal;
    const double length = way.norm();
    way = length > 0 ? Vec3(way / length) : Vec3::Zero();
    return [&d, normal, way](Slot v) -> Vec3 {
        const Vec3 r = d.point(v) - d.dab.position;
        return r - r.dot(normal) * normal - r.dot(way) * way;
    };
}

Field along(const Dabbed& d, double length)
{
    return [&d, length](Slot v, double w) -> Vec3 { return length * w * unitNormal(d.mesh, v); };
}

/// Fuller than Pull, and gentler: +-0.06 R s w (2 - w) n_i, so that all that is under the brush swells.
Field inflate(const Dabbed& d)
{
    return [&d, length = d.sign() * swellPerPeak * d.peak()](Slot v, double w) -> Vec3 {
        return length * w * (2 - w) * unitNormal(d.mesh, v);
    };
}

/// Towards the mean plane raised by a peak (SculptGL's and Blender's clay), by two peaks at most; what stands above it
/// stays. Inverted it digs.
Field clay(const Dabbed& d)
{
    const Plane plane = meanPlane(d);
    return [&d, plane, up = d.sign(), h = d.peak()](Slot v, double w) -> Vec3 {
        return w * up * std::clamp(h - up * plane.height(d.point(v)), 0.0, 2 * h) * plane.normal;
    };
}

/// As high over the surface of the stroke's beginning as the largest sum of weights, up to a peak: n_i h min(1, sum w).
Field layer(const Dabbed& d)
{
    return [&d, up = d.sign(), h = d.peak()](Slot v, double w) -> Vec3 {
        return up * std::clamp(h - d.region.carried(v), 0.0, w * h) * unitNormal(d.mesh, v);
    };
}

/// -s w ((p_i - P_center) . N_avg) N_avg
Field flatten(const Dabbed& d)
{
    return [&d, plane = meanPlane(d), s = d.share()](Slot v, double w) -> Vec3 {
        return -s * w * Vec3(plane.height(d.point(v)) * plane.normal);
    };
}

/// Flatten of what stands above the plane alone; inverted, of what lies below.
Field scrape(const Dabbed& d)
{
    return [&d, plane = meanPlane(d), up = d.sign(), s = d.share()](Slot v, double w) -> Vec3 {
        return -s * w * up * std::max(up * plane.height(d.point(v)), 0.0) * plane.normal;
    };
}

/// s w (mean of the neighbours - p_i)
Field smooth(const Dabbed& d)
{
    return [&d, s = d.share()](Slot v, double w) -> Vec3 { return s * w * (neighbourMean(d.mesh, v) - d.point(v)); };
}

/// Along the surface towards the line. Inverted, away from it.
Field pinch(const Dabbed& d)
{
    const double share = d.sign() * std::min(pinchShare * d.dab.strength, maxPinched);
    return [across = acrossLine(d, meanNormal(d.region, d.mesh)), share](Slot v, double w) -> Vec3 {
        return -share * w * across(v);
    };
}

/// Pinches, and cuts in with a V for a profile: (1 - x)^4 of the distance x from the line, in radii. Inverted it raises
/// a ridge.
Field crease(const Dabbed& d)
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

/// With the hand.
Field follow(const Dabbed& d)
{
    return [way = Vec3(d.share() * d.dab.motion)](Slot, double w) -> Vec3 { return w * way; };
}

/// About the axis through where it took hold, by the turn's share; tan(a/2) = a/2 will do, and is the same on every
/// machine.
Field twist(const Dabbed& d)
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

/// See stamp_shape.h.
Field stamp(const Dabbed& d)
{
    return [&d, stamp = StampShape(frameOn(d.region, d.mesh, d.settings, d.dab), d.settings, d.dab)](
               Slot v, double) -> Vec3 { return stamp.field(d.point(v), 0.5 * longestEdge(d.mesh, v)); };
}

Field fieldOf(const Dabbed& d)
{
    switch (d.settings.tool) {
    case Tool::Pull:
        return along(d, d.peak());
    case Tool::Push:
        return along(d, -d.peak());
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
    case Tool::SnakeHook:
        return follow(d);
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
    return falloff(std::min(distance / dab.radius, 1.0), settings.falloff);
}

Vec3 meanNormal(const Region& region, const Mesh& mesh)
{
    Vec3 normal = Vec3::Zero();
    region.forEach([&](Slot v) { normal += unitNormal(mesh, v); });
    const double length = normal.norm();
    return length > 0 ? Vec3(normal / length) : Vec3::Zero();
}

double planDeformation(Region& region, const Mesh& mesh, const StrokeSettings& settings, const Dab& dab)
{
    const Dabbed dabbed = {region, mesh, settings, dab};
    const Field field = fieldOf(dabbed);
    const DabWeights weights(region, mesh, settings, dab);
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
