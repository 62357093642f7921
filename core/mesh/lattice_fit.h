#pragma once

#include "core/geometry/lattice.h"
#include "core/geometry/triangle_mesh.h"
#include "core/util/job_control.h"

#include <span>
#include <vector>

namespace core
{
/// A surface snapped to a lattice.
struct LatticeFit
{
    std::vector<LatticePoint> points;
    std::size_t resnapped = 0; ///< vertices moved to a neighbouring lattice point to avoid intersections
    /// Faces still degenerate or intersecting after all retries (of at most 1000 intersecting pairs); all faces if the
    /// snapped surface bounds no solid.
    std::size_t unsnappable = 0;
};

/// Returns the lattice point nearest to each point. Precondition: the lattice contains the points.
std::vector<LatticePoint> snappedTo(const Lattice& lattice, std::span<const Vec3> points);

/// Snaps a surface to the lattice and checks it exactly: no degenerate face, no self-intersection, the boundary of a
/// solid. Where faces intersect, their corners are moved to other lattice points nearby. Precondition: the triangles
/// are closed, manifold and oriented. Points without triangles are only snapped. Cost: O(mesh), on all cores. The
/// result of a cancelled call must not be used.
LatticeFit fitToLattice(const Lattice& lattice, std::span<const Vec3> points, std::span<const Triangle> triangles,
                        const JobControl& control = {});

/// Does the same to a surface of several parts, each of which bounds a solid of its own. `parts`: the part of each
/// point; the corners of a face have the same.
LatticeFit fitPartsToLattice(const Lattice& lattice, std::span<const Vec3> points, std::span<const Triangle> triangles,
                             std::span<const PartId> parts, const JobControl& control = {});
} // namespace core
