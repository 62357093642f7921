#include "deform.h"

#include "parallel.h"

#include <algorithm>
#include <cassert>
#include <functional>

namespace core
{
namespace
{
/// At strength 1 the peak of Pull and Push is this part of the radius.
constexpr double peakPerRadius = 0.1;
constexpr std::size_t verticesPerChunk = 256;

Vec3 unitNormal(const Mesh& mesh, Slot v)
{
    const Vec3 normal = vertexNormal(mesh, v);
    const double length = normal.norm();
    return length > 0 ? Vec3(normal / length) : Vec3::Zero();
}

/// The displacement of a vertex at full strength and weight 1, in units of what the tool's strength scales.
using Field = std::function<Vec3(Slot)>;

/// Onto the plane through the mean point (P_center) along the mean normal (N_avg) of the region.
Field flattenField(const Region& region, const Mesh& mesh)
{
    Vec3 center = Vec3::Zero(), normal = Vec3::Zero();
    region.forEach([&](Slot v) {
        center += mesh.point(v).cast<double>();
        normal += unitNormal(mesh, v);
    });
    center /= region.size();
    const double length = normal.norm();
    normal = length > 0 ? Vec3(normal / length) : Vec3::Zero();
    return [&mesh, center, normal](Slot v) -> Vec3 { return (center - mesh.point(v).cast<double>()).dot(normal) * normal; };
}

/// One field a tool (paper, section 3.3).
Field fieldOf(Tool tool, const Region& region, const Mesh& mesh)
{
    switch (tool) {
    case Tool::Pull:
        return [&mesh](Slot v) { return unitNormal(mesh, v); };
    case Tool::Push:
        return [&mesh](Slot v) -> Vec3 { return -unitNormal(mesh, v); };
    case Tool::Flatten:
        return flattenField(region, mesh);
    case Tool::Smooth:
        return [&mesh](Slot v) -> Vec3 { return neighbourMean(mesh, v) - mesh.point(v).cast<double>(); };
    case Tool::Paint:
        break;
    }
    assert(false && "Paint moves nothing");
    return [](Slot) -> Vec3 { return Vec3::Zero(); };
}
} // namespace

Vec3 neighbourMean(const Mesh& mesh, Slot v)
{
    Vec3 sum = Vec3::Zero();
    int n = 0;
    // Sums of lattice coordinates are exact in a double, so their order does not matter.
    mesh.forEachOutgoing(v, [&](Slot h) {
        sum += mesh.point(mesh.to(h)).cast<double>();
        ++n;
    });
    return sum / n;
}

Vec3 vertexNormal(const Mesh& mesh, Slot v)
{
    const auto point = [&](Slot u) { return Vec3(mesh.point(u).cast<double>()); };
    const Vec3 p = point(v);
    Vec3 sum = Vec3::Zero(); // exact: spokes of up to 2^21 units, products below 2^43
    const Slot first = mesh.outgoing(v);
    Vec3 spoke = point(mesh.to(first)) - p;
    Slot h = first;
    do {
        h = mesh.rotate(h);
        const Vec3 next = point(mesh.to(h)) - p;
        sum += spoke.cross(next);
        spoke = next;
    } while (h != first);
    return sum;
}

Vec3 faceNormal(const Mesh& mesh, Slot f)
{
    const Triangle& t = mesh.corners(f);
    const Vec3 a = mesh.point(t[0]).cast<double>();
    return (mesh.point(t[1]).cast<double>() - a).cross(mesh.point(t[2]).cast<double>() - a);
}

double planDeformation(Region& region, const Mesh& mesh, const StrokeSettings& settings, const Dab& dab)
{
    const Field field = fieldOf(settings.tool, region, mesh);
    const bool saturates = settings.tool == Tool::Flatten || settings.tool == Tool::Smooth;
    const double amount = saturates ? std::min(dab.strength, 1.0) : peakPerRadius * dab.radius * dab.strength;
    const std::vector<Slot>& slots = region.slots();
    std::vector<double> longest2(1 + chunksOf(slots.size(), verticesPerChunk), 0.0);
    forEachChunk(slots.size(), verticesPerChunk, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const Slot v = slots[i];
            if (!region.contains(v))
                continue;
            const double weight = falloff(std::min(region.distance(v) / dab.radius, 1.0), settings.falloff);
            const Vec3 plan = amount * weight * field(v);
            region.setPlan(v, plan);
            longest2[chunk] = std::max(longest2[chunk], plan.squaredNorm());
        }
    });
    return std::sqrt(*std::ranges::max_element(longest2));
}

void calmPlan(Region& region, const Mesh& mesh, std::span<const Slot> vertices)
{
    std::vector<std::pair<Slot, Vec3>> calmed;
    for (Slot v : withNeighbours(region, mesh, vertices)) {
        const Vec3 plan = region.plan(v);
        Vec3 sum = plan;
        mesh.forEachOutgoing(v, [&](Slot h) {
            if (region.contains(mesh.to(h)))
                sum += region.plan(mesh.to(h));
        });
        const double length = sum.norm();
        if (length > 0)
            calmed.emplace_back(v, plan.norm() / length * sum);
    }
    for (const auto& [v, plan] : calmed)
        region.setPlan(v, plan);
}
} // namespace core
