#pragma once

#include "core/geometry/geometry.h"

#include <span>

namespace core
{
struct Rectangle
{
    double length = 0, width = 0; ///< length >= width
};

/// Returns the rectangle of least area around the points, projected onto the plane nearest to them. Among equal
/// rectangles, the shortest. Cost: one sort, and the square of the number of convex hull corners.
Rectangle rectangleAround(std::span<const Vec3> points);
} // namespace core
