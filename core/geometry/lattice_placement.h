#pragma once

#include "core/geometry/lattice.h"

namespace core
{
/// A lattice for a model, and the translation that moves the model onto it.
struct LatticePlacement
{
    Lattice lattice;
    Vec3 moved = Vec3::Zero(); ///< translation added to each point before it is snapped, mm; a lattice vector

    /// Returns the nearest lattice point of the translated p, clamped to the lattice. Only points outside the model's
    /// box can need clamping.
    LatticePoint toLattice(const Vec3f& p) const;
};

/// Returns whether the box's centre is farther from the origin than four times the box's longest side.
bool isFarFromOrigin(const Box& box);

/// Returns the mean edge length of a surface of this area and number of faces, in units of the float32 spacing at the
/// box's largest coordinate. Assumes equilateral faces.
double floatStepsPerEdge(const Box& box, double area, std::size_t faces);

/// Returns whether the model is so far from the origin that float32 coordinates are too coarse to sculpt it in place:
/// its mean edge is shorter than 32 float32 steps.
bool isTooFarForFloats(const Box& box, double area, std::size_t faces);

/// Returns the finest lattice for a model with this bounding box, which must not be a single point. A model far from
/// the origin is moved to the origin, because the lattice would be too coarse for it. `centre`: moves any model.
LatticePlacement placeOnLattice(const Box& box, bool centre = false);

/// Returns the lattice for a model on the lattice `present` whose bounding box becomes `box`. Keeps `present` while it
/// has enough room and detail; otherwise returns the lattice that an import would choose.
Lattice latticeFor(const Box& box, const Lattice& present);
} // namespace core
