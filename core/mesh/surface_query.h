#pragma once

#include "core/mesh/face_octree.h"
#include "core/mesh/surface_hit.h"

#include <array>
#include <functional>
#include <limits>
#include <optional>

namespace core
{
/// Returns the first hit of the ray on the front side of a face. Cost: O(faces near the ray).
std::optional<SurfaceHit> firstHit(const Mesh& mesh, const FaceOctree& octree, const Ray& ray);

/// A function that returns the corners of face f, mm.
using CornersOf = std::function<std::array<Vec3, 3>(Slot f)>;
/// Returns the first hit on a surface with the mesh's faces but corners from `cornersOf`. `farthest`: largest distance
/// of a corner from the same corner in the mesh, mm.
std::optional<SurfaceHit> firstHit(const Mesh& mesh, const FaceOctree& octree, const Ray& ray,
                                   const CornersOf& cornersOf, double farthest);

/// Returns the nearest point of the surface within the distance `within`, mm. Cost: O(faces in the ball that reaches
/// the result), up to all faces for a point far from the surface.
std::optional<SurfaceHit> nearestPoint(const Mesh& mesh, const FaceOctree& octree, const Vec3& point,
                                       double within = std::numeric_limits<double>::infinity());

/// Returns the vertex at lattice point p, or noSlot. Precondition: the octree is up to date.
Slot vertexAt(const Mesh& mesh, const FaceOctree& octree, const Vec3f& p);
} // namespace core
