#pragma once

#include "core/mesh/face_octree.h"
#include "core/mesh/surface_hit.h"

#include <array>
#include <functional>
#include <limits>
#include <optional>

namespace core
{
/// Returns the first hit on a face that faces the ray's origin. Cost: the faces near the ray.
std::optional<SurfaceHit> firstHit(const Mesh& mesh, const FaceOctree& octree, const Ray& ray);

/// Returns the corners of a face.
using CornersOf = std::function<std::array<Vec3, 3>(Slot f)>;
/// Returns the first hit on a surface that has the mesh's faces, but other corners. `farthest`: the largest distance of
/// a corner from the mesh's, in mm.
std::optional<SurfaceHit> firstHit(const Mesh& mesh, const FaceOctree& octree, const Ray& ray,
                                   const CornersOf& cornersOf, double farthest);

/// The nearest point of the surface, if it is no farther than `within`. Cost: the faces in the ball that reaches it,
/// which of a point in empty space may be all.
std::optional<SurfaceHit> nearestPoint(const Mesh& mesh, const FaceOctree& octree, const Vec3& point,
                                       double within = std::numeric_limits<double>::infinity());

/// The vertex at that lattice point, or noSlot. Precondition: the octree is up to date.
Slot vertexAt(const Mesh& mesh, const FaceOctree& octree, const Vec3f& p);
} // namespace core
