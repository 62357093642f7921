#pragma once

#include "core/geometry/geometry.h"

#include <span>

namespace core::repair
{
struct Rectangle
{
    double length = 0, width = 0; ///< length >= width
};

/// Returns the rectangle of least area around the points as they lie in the plane nearest to them; of equal ones, the
/// shortest. Cost: a sort, and the square of the corners of their convex hull.
Rectangle rectangleAround(std::span<const Vec3> points);
} // namespace core::repair
