#pragma once

#include "core/geometry/geometry.h"

#include <cstddef>
#include <vector>

namespace core
{
/// Returns the indices of the points of a path that remain, in ascending order, if those at most `tolerance` from the
/// line through the remaining ones before and after are left out (Douglas and Peucker 1973). First and last point
/// remain. `tolerance` is in the unit of the points. Thread: any. Cost: quadratic at worst.
std::vector<std::size_t> simplifiedPath(const std::vector<Vec3>& path, double tolerance);
} // namespace core
