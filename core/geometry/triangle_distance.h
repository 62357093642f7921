#pragma once

#include "core/geometry/geometry.h"

namespace core
{
/// The nearest points of two sets.
struct NearestPair
{
    Vec3 a = Vec3::Zero(), b = Vec3::Zero();
    double squaredDistance = std::numeric_limits<double>::infinity();
};

/// Returns the nearest points of two segments (Ericson 2005, section 5.1.9).
NearestPair nearestOfSegments(const Vec3& a0, const Vec3& a1, const Vec3& b0, const Vec3& b1);

/// Returns the nearest points of a triangle and a segment; a common point if the segment pierces the triangle.
NearestPair nearestOfTriangleAndSegment(const std::array<Vec3, 3>& a, const Vec3& b0, const Vec3& b1);

/// Returns the nearest points of two triangles; a common point if they cross. Cost: at most 15 pairs of a corner or a
/// side of one and of the other.
NearestPair nearestOfTriangles(const std::array<Vec3, 3>& a, const std::array<Vec3, 3>& b);
} // namespace core
