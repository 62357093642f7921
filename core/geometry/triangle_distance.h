#pragma once

#include "core/geometry/geometry.h"

namespace core
{
/// The nearest points of two sets: a in the first, b in the second.
struct NearestPair
{
    Vec3 a = Vec3::Zero(), b = Vec3::Zero();
    double squaredDistance = std::numeric_limits<double>::infinity();
};

/// Returns the nearest points of two segments (Ericson 2005, section 5.1.9).
NearestPair nearestOfSegments(const Vec3& a0, const Vec3& a1, const Vec3& b0, const Vec3& b1);

/// Returns the nearest points of a triangle and a segment. If the segment pierces the triangle, a and b are equal.
NearestPair nearestOfTriangleAndSegment(const std::array<Vec3, 3>& a, const Vec3& b0, const Vec3& b1);

/// Returns the nearest points of two triangles. If the triangles cross, a and b are equal. Cost: at most 15 distances:
/// 6 between a corner and a triangle, 9 between two sides.
NearestPair nearestOfTriangles(const std::array<Vec3, 3>& a, const std::array<Vec3, 3>& b);
} // namespace core
