#pragma once

#include "core/geometry/triangle_mesh.h"
#include "core/util/job_control.h"

namespace core
{
/// Shares, 0 to 1, of the space that two surfaces enclose together.
struct SpaceDifference
{
    double lost = 0;   ///< only the old one does
    double gained = 0; ///< only the new one does
};

/// Compares the space within `solid`, which is closed and faces outwards, with the space that `faces` wind around more
/// than half, either way (generalized winding number; Jacobson, Kavan and Sorkine-Hornung 2013). They may be open:
/// where they wind around a point by about a half, either answer is as good, so a point counts by how far its winding
/// number is from that. Up to 65,536 points in their box. Both have faces, in one unit. All cores; the same on any
/// machine. If it is cancelled, the result is not usable. Cost: two WindingNumbers and 20 us a point.
SpaceDifference spaceDifference(const TriangleMesh& faces, const TriangleMesh& solid, const JobControl& control = {});
} // namespace core
