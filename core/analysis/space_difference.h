#pragma once

#include "core/geometry/triangle_mesh.h"
#include "core/util/job_control.h"

namespace core
{
/// Shares, 0 to 1, of the space that at least one of an old and a new surface encloses.
struct SpaceDifference
{
    double lost = 0;   ///< share that only the old surface encloses
    double gained = 0; ///< share that only the new surface encloses
};

/// Differences of two readings of the old surface.
struct SpaceDifferences
{
    SpaceDifference eitherWay; ///< it encloses where its winding number is above 0.5 or below -0.5
    SpaceDifference outwards;  ///< it encloses where its winding number is above 0.5
};

/// Compares the space within `solid`, which is closed, faces outwards and does not meet itself, with the space that
/// `faces` wind around (generalized winding number; Jacobson, Kavan and Sorkine-Hornung 2013). `faces` may be open.
/// Where their winding number is about a half, inside and outside are equally right: there a point's weight falls to 0.
/// Samples up to 65,536 points: a quarter in the common box, the rest in the boxes of components. Sampling stops at
/// 16,384 points inside either surface, and at 4,096 if all of them are inside both, for both readings: a difference of
/// less than about 0.05 % may be missed. Precondition: both meshes have faces and use one unit. Uses all cores; every
/// machine gets the same result. The result of a cancelled call must not be used.
/// Cost: SolidAngles, a WindingNumber, and a query of each per point.
SpaceDifferences spaceDifferences(const TriangleMesh& faces, const TriangleMesh& solid, const JobControl& control = {});
} // namespace core
