#pragma once

#include "core/geometry/lattice_placement.h"
#include "core/geometry/triangle_mesh.h"

namespace core::repair
{
/// Copies masks to a repaired model. Each point gets the greatest mask of the old points at the same lattice point, or
/// none. Precondition: the repaired model is on the lattice of `placement`. Returns the number of masked positions that
/// no longer exist.
std::size_t transferMasks(const TriangleMesh& old, const LatticePlacement& placement, TriangleMesh& repaired);
} // namespace core::repair
