#pragma once

#include "core/mesh/mesh.h"

namespace core
{
/// How far p lies from the planes of the faces around the ends of h: the mean square, by their areas.
double planeError(const Mesh& mesh, Slot h, const Vec3& p);

/// Whether faces that look away from each other, more than any around one vertex did, would come to share one by the
/// collapse of h: the two sides of a wall whose rim is to go.
bool foldsUp(const Mesh& mesh, Slot h);
} // namespace core
