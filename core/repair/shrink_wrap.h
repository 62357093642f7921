#pragma once

#include "core/repair/triangle_soup.h"

#include "core/util/job_control.h"

namespace core::repair
{
/// Returns a new mesh of the boundary of the space whose winding number exceeds a half. The mesh is closed, manifold
/// and free of intersections for any input, and empty if there is no such space. Vertices are on the surface, or midway
/// between grid points where the surface is open. Edges and corners are cut off by up to a cell. `cell`: >= 64, lattice
/// units.
/// Uses marching tetrahedra (Doi and Koide 1991) on the winding number (Jacobson, Kavan and Sorkine-Hornung 2013), only
/// near the boundary, on all cores. Cost: about 20 us per cell at the boundary.
TriangleSoup shrinkWrap(const TriangleSoup& surface, int cell, const JobControl& control = {});

/// Returns a cell size for shrinkWrap(), lattice units: half the mean edge, limited to 1/256 to 1/64 of the longest
/// side.
int cellFor(const TriangleSoup& surface);
} // namespace core::repair
