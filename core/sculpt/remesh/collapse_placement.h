#pragma once

#include "core/mesh/mesh.h"

namespace core
{
/// Returns the mean squared distance of p from the planes of the faces around the ends of h, weighted by face area,
/// mm2.
double planeError(const Mesh& mesh, Slot h, const Vec3& p);

/// Returns whether collapsing h would merge the two sides of a thin wall: faces that share no vertex before, and face
/// away from each other more than any faces around one of its ends, would share a vertex.
bool foldsUp(const Mesh& mesh, Slot h);
} // namespace core
