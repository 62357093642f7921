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

/// Returns the mean edge of a surface of this area and number of faces, above 0, in steps of the box's largest 32-bit
/// coordinate.
double floatStepsPerEdge(const Box& box, double area, std::size_t faces);

/// The model lies far from the origin, and 32-bit coordinates there are too coarse to sculpt it where it lies: its mean
/// edge is shorter than 32 steps.
bool isTooFarForFloats(const Box& box, double area, std::size_t faces);

/// The finest lattice for a model with this bounding box (not a single point). A model that lies far from the origin is
/// moved there: the lattice would be too coarse for it. With `centre` any model.
LatticePlacement placeOnLattice(const Box& box, bool centre = false);

/// For a model that has a lattice and comes to this box: the same one while there is room to sculpt on it, and detail,
/// else the one that an import would choose.
Lattice latticeFor(const Box& box, const Lattice& present);
} // namespace core
