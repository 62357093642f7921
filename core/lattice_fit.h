#pragma once

#include "lattice.h"
#include "mesh_build.h"

namespace core
{
/// A model moved and snapped to its lattice.
struct LatticeFit
{
    TriangleMesh mesh;
    Lattice lattice;
    Vec3 moved = Vec3::Zero();
    bool exact = false; ///< no point was moved by the snapping
};

/// Precondition: the model has a point other than the origin. Does not judge the result.
LatticeFit fitToLattice(const TriangleMesh& model, Placing placing);
} // namespace core
