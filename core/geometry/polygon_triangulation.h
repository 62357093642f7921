#pragma once

#include "core/geometry/geometry.h"

#include <optional>
#include <span>
#include <vector>

namespace core
{
/// Of a plane lattice; |coordinate| <= Lattice::limit.
using FlatPoint = Eigen::Vector2i;

/// Triangles that fill what the loops enclose: what is filled lies to the left of each, so that holes run the other way
/// round. Every point of the loops is a corner, no other is; triangles wind anticlockwise. Exact. Nothing if the loops
/// cross, touch, or enclose nothing. Cost: the points times those at which the loops are not convex.
std::optional<std::vector<Triangle>> triangulatePolygon(std::span<const FlatPoint> points,
                                                        std::vector<std::vector<Slot>> loops);
} // namespace core
