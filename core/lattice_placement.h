#pragma once

#include "lattice.h"

namespace core
{
/// Where a model goes on its lattice.
struct LatticePlacement
{
    Lattice lattice;
    Vec3 moved = Vec3::Zero(); ///< added to each point before it is snapped; on the lattice

    /// Clamped to the lattice's volume, which only a point outside the box can leave.
    LatticePoint toLattice(const Vec3f& p) const;
};

/// The finest lattice for a model with this bounding box (not a single point). A model whose centre is farther from the
/// origin than four times its longest side is moved there: the lattice would be too coarse for it. With `centre` any model.
LatticePlacement placeOnLattice(const Box& box, bool centre = false);
} // namespace core
