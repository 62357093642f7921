#pragma once

#include "core/mesh/face_octree.h"
#include "core/mesh/surface_hit.h"

#include <limits>
#include <optional>

namespace core
{
/// The first face from the ray's origin on that faces it. Cost: the faces near the ray.
std::optional<SurfaceHit> firstHit(const Mesh& mesh, const FaceOctree& octree, const Ray& ray);

/// The nearest point of the surface, if it is no farther than `within`. Cost: the faces in the ball that reaches it,
/// which of a point in empty space may be all.
std::optional<SurfaceHit> nearestPoint(const Mesh& mesh, const FaceOctree& octree, const Vec3& point,
                                       double within = std::numeric_limits<double>::infinity());

/// The vertex at that lattice point, or noSlot. Precondition: the octree is up to date.
Slot vertexAt(const Mesh& mesh, const FaceOctree& octree, const Vec3f& p);
} // namespace core
