#pragma once

#include "core/geometry/geometry.h"

namespace core
{
/// Returns the point of a triangle nearest to p (Ericson 2005, section 5.1.5).
Vec3 nearestInTriangle(const Vec3& p, const std::array<Vec3, 3>& triangle);
} // namespace core
