#pragma once

#include "core/geometry/lattice.h"
#include "core/geometry/triangle_mesh.h"

namespace core
{
/// Returns the Morton code of the upper 21 of the 24 bits of each coordinate.
std::uint64_t mortonCodeOf(const LatticePoint& p);

/// Returns the mesh with vertices sorted along a Morton curve and faces sorted by their smallest corner, which becomes
/// the first corner. Elements near in space are then near in memory. The result does not depend on the input's order.
TriangleMesh inMortonOrder(const TriangleMesh& mesh, const Lattice& lattice);
} // namespace core
