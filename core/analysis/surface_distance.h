#pragma once

#include "core/geometry/triangle_mesh.h"
#include "core/util/job_control.h"

#include <span>

namespace core
{
/// How far one surface lies from another, in the model's unit.
struct SurfaceDistance
{
    double largest = 0;
    double mean = 0; ///< over the area
};

/// From `a` to the nearest points of `b`: at 200,000 points of a, evenly by area, and at those of its corners that b
/// does not have. The larger of both ways is the Hausdorff distance, as closely as the samples show it. Both have
/// faces. All cores; the same on any machine. If it is cancelled, the result is not usable. 2 to 50 us a sample, the
/// more the farther apart they are.
SurfaceDistance distanceFrom(const TriangleMesh& a, const TriangleMesh& b, const JobControl& control = {});

/// The mean alone, at 25,000 points, where points of `a` that lie inside of `b` count as lying on it. `b` is closed and
/// faces outwards. Winding numbers (10 us) at the samples that lie farther from it than `near`.
double meanDistanceOutside(const TriangleMesh& a, const TriangleMesh& b, double near, const JobControl& control = {});

/// Of each point the distance to the nearest point of `surface`, which has faces. All cores; the same on any machine.
/// If it is cancelled, the result is not usable. 2 to 50 us a point, faster where neighbours in the list are near each
/// other.
std::vector<float> distancesTo(const TriangleMesh& surface, std::span<const Vec3f> points,
                               const JobControl& control = {});
} // namespace core
