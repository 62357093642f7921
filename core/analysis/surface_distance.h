#pragma once

#include "core/geometry/triangle_mesh.h"
#include "core/util/job_control.h"

#include <span>

namespace core
{
/// Distances from the points of one surface to another surface, in the model's unit.
struct SurfaceDistance
{
    double largest = 0;
    double mean = 0; ///< mean over the area
};

/// Measures the distance from `a` to the nearest points of `b`, at 100 points per face of a, but at 20,000 to 200,000
/// in all, spread evenly by area, and at the corners of a that b does not have. The larger of the distances a to b and
/// b to a approximates the Hausdorff distance. Precondition: both meshes have faces. Uses all cores; every machine gets
/// the same result. The result of a cancelled call must not be used. Cost: 2 to 50 us per sample, more for surfaces
/// that are far apart.
SurfaceDistance distanceFrom(const TriangleMesh& a, const TriangleMesh& b, const JobControl& control = {});

/// Returns the mean distance at 25,000 points of `a`; points inside `b` count as distance 0. Precondition: b is closed
/// and free of self-intersections. Cost: as distanceFrom(), and 2 us for each sample farther than `reach` from b.
double meanDistanceOutside(const TriangleMesh& a, const TriangleMesh& b, double reach, const JobControl& control = {});

/// Returns the distance from each point to the nearest point of `surface`. Precondition: the surface has faces. Uses
/// all cores; every machine gets the same result. The result of a cancelled call must not be used. Cost: 2 to 50 us per
/// point, less if neighbours in the list are near each other.
std::vector<float> distancesTo(const TriangleMesh& surface, std::span<const Vec3f> points,
                               const JobControl& control = {});
} // namespace core
