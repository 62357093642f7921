#pragma once

#include "core/geometry/polygon_triangulation.h"

#include <span>
#include <vector>

namespace core
{
using FlatLoop = std::vector<FlatPoint>;

/// Returns the outline of the area that a closed curve goes around, which may cross, touch and overlap itself: the
/// points whose winding number is not zero. Outer loops run anticlockwise, holes clockwise. Where loops would touch in
/// a point, each is drawn back from it by some units. Parts thinner than some units are dropped; if nothing is left,
/// there is no loop. Units: of a plane lattice.
///
/// Precondition: |coordinate| <= Lattice::limit / 2. Cost: quadratic in the corners. Method: segments are cut where
/// they meet, at rounded points, until they only meet at their ends (Hobby 1999, "Practical segment intersection with
/// finite precision output", without its guarantee: after some rounds the curve counts as one without area).
std::vector<FlatLoop> windingOutline(std::span<const FlatPoint> curve);
} // namespace core
