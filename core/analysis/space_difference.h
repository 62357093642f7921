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

/// Says what space a surface encloses.
enum class WoundAround {
    EitherWay, ///< by more than a half, inwards or outwards
    Outwards   ///< by more than a half, outwards
};

/// Compares the space within `solid`, which is closed and faces outwards, with the space that `faces` wind around
/// (generalized winding number; Jacobson, Kavan and Sorkine-Hornung 2013). They may be open: where they wind around a
/// point by about a half, either answer is as good, so a point counts by how far its winding number is from that. Up to
/// 65,536 points, a quarter of them in the box of both, the rest in the boxes of components. Both have faces, in one
/// unit. All cores; the same on any machine. If it is cancelled, the result is not usable. Cost: two WindingNumbers and
/// some 20 us a point.
SpaceDifference spaceDifference(const TriangleMesh& faces, WoundAround counted, const TriangleMesh& solid,
                                const JobControl& control = {});
} // namespace core
