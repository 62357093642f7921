#pragma once

#include "core/geometry/geometry.h"

namespace core
{
/// Returns the point of a triangle nearest to p (Ericson 2005, section 5.1.5).
Vec3 nearestInTriangle(const Vec3& p, const std::array<Vec3, 3>& triangle);

/// Returns the barycentric weights of a triangle's corners at a point p in the triangle. Each weight is the area of the
/// triangle between p and the opposite side, as a share of the sum of the three areas.
inline std::array<double, 3> cornerWeights(const Vec3& p, const std::array<Vec3, 3>& triangle)
{
    const auto& [a, b, c] = triangle;
    const double atA = (b - p).cross(c - p).norm(), atB = (c - p).cross(a - p).norm(),
                 atC = (a - p).cross(b - p).norm();
    const double area = atA + atB + atC;
    return {atA / area, atB / area, atC / area};
}

/// Intersects a ray with the front side of a triangle (Möller and Trumbore 1997). Returns the hit as a multiple of the
/// ray's direction, negative for a miss.
inline double hitTriangle(const Ray& ray, const std::array<Vec3, 3>& triangle)
{
    const auto& [a, b, c] = triangle;
    const Vec3 ab = b - a, ac = c - a;
    const Vec3 p = ray.direction.cross(ac);
    const double determinant = ab.dot(p);
    if (!(determinant > 0))
        return -1;
    const Vec3 s = ray.origin - a;
    const double u = s.dot(p);
    if (u < 0 || u > determinant)
        return -1;
    const Vec3 q = s.cross(ab);
    const double v = ray.direction.dot(q);
    if (v < 0 || u + v > determinant)
        return -1;
    return ac.dot(q) / determinant;
}
} // namespace core
