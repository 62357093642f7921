#pragma once

#include "core/geometry/lattice.h"
#include "core/util/job_control.h"

#include <span>
#include <vector>

namespace core
{
/// A surface put on a lattice.
struct LatticeFit
{
    std::vector<LatticePoint> points;
    std::size_t resnapped = 0;   ///< vertices that went to a neighbouring lattice point, so that no faces meet
    std::size_t unsnappable = 0; ///< faces that are unsound on the lattice whatever was tried
};

/// Each point to the lattice point nearest to it. Precondition: the lattice contains them.
std::vector<LatticePoint> snappedTo(const Lattice& lattice, std::span<const Vec3> points);

/// Snaps the surface and checks it exactly: no face degenerate, no two meeting, the boundary of a solid. Where faces
/// came to meet, corners are sent to other lattice points nearby. The triangles are closed, manifold and oriented;
/// points that none of them uses are only snapped. Whole-mesh cost, on all cores. If it is cancelled, the result is not
/// usable.
LatticeFit fitToLattice(const Lattice& lattice, std::span<const Vec3> points, std::span<const Triangle> triangles,
                        const JobControl& control = {});
} // namespace core
