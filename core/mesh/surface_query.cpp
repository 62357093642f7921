#include "core/mesh/surface_query.h"

#include "core/geometry/point_triangle.h"

#include <algorithm>

namespace core
{
namespace
{
using Corners = std::array<Vec3, 3>;

Corners cornersOf(const Mesh& mesh, Slot f)
{
    const Triangle& t = mesh.corners(f);
    return {mesh.point(t[0]).cast<double>(), mesh.point(t[1]).cast<double>(), mesh.point(t[2]).cast<double>()};
}

/// Returns whether the ray meets the box (slab test, Kay and Kajiya 1986).
bool meetsBox(const Ray& ray, const Box& box)
{
    double enter = 0, leave = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 3; ++i) {
        const double d = ray.direction[i];
        if (d == 0) {
            if (ray.origin[i] < box.min()[i] || ray.origin[i] > box.max()[i])
                return false;
            continue;
        }
        const double t0 = (box.min()[i] - ray.origin[i]) / d, t1 = (box.max()[i] - ray.origin[i]) / d;
        enter = std::max(enter, std::min(t0, t1));
        leave = std::min(leave, std::max(t0, t1));
    }
    return enter <= leave;
}

Rgb colorAt(const Mesh& mesh, Slot f, const Corners& t, const Vec3& position)
{
    const std::array<double, 3> weights = cornerWeights(position, t);
    Vec3 mean = Vec3::Constant(0.5);
    for (std::size_t i = 0; i < 3; ++i) {
        const Rgb color = mesh.color(mesh.corners(f)[i]);
        mean += weights[i] * Vec3(color.r, color.g, color.b);
    }
    return {static_cast<std::uint8_t>(mean.x()), static_cast<std::uint8_t>(mean.y()),
            static_cast<std::uint8_t>(mean.z())};
}

SurfaceHit surfaceHit(const Mesh& mesh, Slot f, const Corners& t, const Vec3& position, double distance)
{
    return {position, (t[1] - t[0]).cross(t[2] - t[0]).normalized(), distance, f, colorAt(mesh, f, t, position)};
}

/// Returns the first hit on the mesh's faces with corners from `cornersOf`, which are at most `farthest` mm away from
/// the mesh's corners.
template <class Of>
std::optional<SurfaceHit> firstHitOf(const Mesh& mesh, const FaceOctree& octree, const Ray& ray, const Of& cornersOf,
                                     double farthest)
{
    const double unit = mesh.lattice().unit();
    const Vec3 margin = Vec3::Constant(farthest);
    double first = std::numeric_limits<double>::infinity();
    Slot face = noSlot;
    const auto enter = [&](const LatticeBox& box) {
        return meetsBox(ray, {box.min.cast<double>() * unit - margin, box.max.cast<double>() * unit + margin});
    };
    octree.traverse(enter, [&](Slot f) {
        const double t = hitTriangle(ray, cornersOf(f));
        if (t >= 0 && (t < first || (t == first && f < face)) && !mesh.isFaceHidden(f)) {
            first = t;
            face = f;
        }
    });
    if (face == noSlot)
        return std::nullopt;
    return surfaceHit(mesh, face, cornersOf(face), ray.origin + first * ray.direction, first * ray.direction.norm());
}
} // namespace

std::optional<SurfaceHit> firstHit(const Mesh& mesh, const FaceOctree& octree, const Ray& ray)
{
    return firstHitOf(
        mesh, octree, ray, [&](Slot f) { return cornersOf(mesh, f); }, 0);
}

std::optional<SurfaceHit> firstHit(const Mesh& mesh, const FaceOctree& octree, const Ray& ray,
                                   const CornersOf& cornersOf, double farthest)
{
    return firstHitOf(mesh, octree, ray, cornersOf, farthest);
}

std::optional<SurfaceHit> nearestPoint(const Mesh& mesh, const FaceOctree& octree, const Vec3& point, double within)
{
    const double unit = mesh.lattice().unit();
    const double everything = 2 * (point.cwiseAbs() + Vec3::Constant(mesh.lattice().halfVolume())).norm();
    const double max = std::min(everything, within);
    double radius = std::min(octree.smallestCell() * unit, max);
    while (true) {
        double nearest2 = std::numeric_limits<double>::infinity();
        Slot face = noSlot;
        Vec3 position = Vec3::Zero();
        octree.query(latticeBox(mesh.lattice(), {point, radius}), [&](Slot f) {
            const Vec3 candidate = nearestInTriangle(point, cornersOf(mesh, f));
            const double d2 = (candidate - point).squaredNorm();
            if (d2 < nearest2 || (d2 == nearest2 && f < face)) {
                nearest2 = d2;
                face = f;
                position = candidate;
            }
        });
        if (face != noSlot && nearest2 <= radius * radius)
            return surfaceHit(mesh, face, cornersOf(mesh, face), position, std::sqrt(nearest2));
        if (!(radius < max))
            return std::nullopt; // no face within `max`, or NaN coordinates
        radius = std::min(2 * radius, max);
    }
}

Slot vertexAt(const Mesh& mesh, const FaceOctree& octree, const Vec3f& p)
{
    const LatticePoint at = mesh.lattice().toLattice(p);
    Slot found = noSlot;
    octree.query({at, at}, [&](Slot f) {
        for (Slot corner : mesh.corners(f)) {
            if (mesh.point(corner) == p)
                found = corner;
        }
    });
    return found;
}
} // namespace core
