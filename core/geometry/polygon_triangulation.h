#pragma once

#include "core/geometry/geometry.h"

#include <optional>
#include <span>
#include <vector>

namespace core
{
/// A point of a plane lattice; |coordinate| <= Lattice::limit.
using FlatPoint = Eigen::Vector2i;

/// Triangulates the area to the left of all loops: outer loops run anticlockwise, holes clockwise. The corners are
/// exactly the points of the loops; triangles wind anticlockwise. The result is exact. Returns nothing if loops cross,
/// touch or enclose nothing. Cost: O(points x non-convex corners).
std::optional<std::vector<Triangle>> triangulatePolygon(std::span<const FlatPoint> points,
                                                        std::vector<std::vector<Slot>> loops);
} // namespace core
