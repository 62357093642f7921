#pragma once

#include "core/geometry/lattice.h"
#include "core/geometry/triangle_mesh.h"

namespace core
{
/// Of the upper 21 of the 24 bits of each coordinate.
std::uint64_t mortonCodeOf(const LatticePoint& p);

/// The same mesh with vertices along a Morton curve (by their lattice points) and faces by their smallest corner, which
/// comes first: elements that are near in space are near in memory. Does not depend on the order of the input.
TriangleMesh inMortonOrder(const TriangleMesh& mesh, const Lattice& lattice);
} // namespace core
