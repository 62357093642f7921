#pragma once

#include "core/analysis/self_intersection.h"
#include "core/repair/triangle_soup.h"

#include <cstddef>
#include <span>

namespace core::repair
{
/// Adds a small closed solid around each place of these points: then the whole must be resolved again. `radius`:
/// lattice units, >= 16.
void coverPoints(TriangleSoup& surface, std::span<const Slot> points, int radius);

struct CoveredKnots
{
    std::size_t count = 0;
    double largest = 0; ///< diameter of the largest solid, lattice units
};

/// Covers knots: places where faces of these pairs meet, one solid for those whose common boxes overlap. What lies
/// within it is no boundary any more when the whole is resolved again, and the rest of the surface stays. Knots wider
/// than `widest` (lattice units) are left. The solids' points and faces are the last of the surface.
CoveredKnots coverKnots(TriangleSoup& surface, std::span<const FacePair> pairs, double widest);
} // namespace core::repair
