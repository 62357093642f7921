#pragma once

#include "core/geometry/lattice_placement.h"
#include "core/geometry/triangle_mesh.h"

namespace core::repair
{
/// What is masked of a model stays so: each point of the repaired one has the mask of the old one that lies there on
/// the lattice, of several the greatest; new points have none. Returns how many masked places are gone. The repaired
/// model lies on that lattice.
std::size_t transferMasks(const TriangleMesh& old, const LatticePlacement& placement, TriangleMesh& repaired);
} // namespace core::repair
