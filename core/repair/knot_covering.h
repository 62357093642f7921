#pragma once

#include "core/analysis/self_intersection.h"
#include "core/repair/triangle_soup.h"

#include <cstddef>
#include <span>

namespace core::repair
{
/// Adds a small closed solid around each distinct position of these points. The surface must then be resolved again.
/// `radius`: >= 16, lattice units.
void coverPoints(TriangleSoup& surface, std::span<const Slot> points, int radius);

struct CoveredKnots
{
    std::size_t count = 0;
    double largest = 0; ///< diameter of the largest solid, lattice units
};

/// Covers knots: places where the faces of these pairs meet. A pair's place is the intersection of its faces' boxes;
/// pairs whose places overlap form one knot and get one solid. When the surface is resolved again, everything inside a
/// solid disappears; the rest of the surface stays. Knots wider than `widest` (lattice units) are not covered. The
/// solids' points and faces are appended to the surface.
CoveredKnots coverKnots(TriangleSoup& surface, std::span<const FacePair> pairs, double widest);
} // namespace core::repair
