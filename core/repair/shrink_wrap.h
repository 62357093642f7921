#pragma once

#include "core/repair/triangle_soup.h"

#include "core/util/job_control.h"

namespace core::repair
{
/// The boundary of the space that the surface winds around by more than a half, made anew: closed, manifold, without
/// intersections whatever the surface is, empty if there is no such space. Its vertices lie on the surface where there
/// is one, and midway where it is open; edges and corners are cut by up to a cell. `cell`: lattice units, >= 64.
/// Marching tetrahedra (Doi and Koide 1991) on the winding number (Jacobson, Kavan and Sorkine-Hornung 2013), only
/// where the boundary runs. All cores; about 20 us a cell there.
TriangleSoup shrinkWrap(const TriangleSoup& surface, int cell, const JobControl& control = {});

/// A cell for wrap(): half the mean edge, but of the longest side no more than a 64th and no less than a 256th.
int cellFor(const TriangleSoup& surface);
} // namespace core::repair
