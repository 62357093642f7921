#pragma once

#include "face_octree.h"

#include <limits>
#include <optional>

namespace core
{
/// A point of the surface.
struct SurfaceHit
{
    Vec3 position;
    Vec3 normal;     ///< of the face, unit length, outwards
    double distance; ///< from the ray's origin, or from the point asked about
    Slot face;
    Rgb color = {}; ///< there, between those of the face's corners
};

/// The first face from the ray's origin on that faces it. Cost: the faces near the ray.
std::optional<SurfaceHit> firstHit(const Mesh& mesh, const FaceOctree& octree, const Ray& ray);

/// The nearest point of the surface, if it is no farther than `within`. Cost: the faces in the ball that reaches it, which of a point in
/// empty space may be all.
std::optional<SurfaceHit> nearestPoint(const Mesh& mesh, const FaceOctree& octree, const Vec3& point,
                                       double within = std::numeric_limits<double>::infinity());
} // namespace core
