#pragma once

#include "core/geometry/lattice.h"

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

/// The box's centre is farther from the origin than four times its longest side.
bool isFarFromOrigin(const Box& box);

/// The finest lattice for a model with this bounding box (not a single point). A model that lies far from the origin is
/// moved there: the lattice would be too coarse for it. With `centre` any model.
LatticePlacement placeOnLattice(const Box& box, bool centre = false);

/// For a model that has a lattice and comes to this box: the same one while there is room to sculpt on it, and detail,
/// else the one that an import would choose.
Lattice latticeFor(const Box& box, const Lattice& present);
} // namespace core
