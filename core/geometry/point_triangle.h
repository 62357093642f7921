#pragma once

#include "core/geometry/geometry.h"

namespace core
{
/// Returns the point of a triangle nearest to p (Ericson 2005, section 5.1.5).
Vec3 nearestInTriangle(const Vec3& p, const std::array<Vec3, 3>& triangle);

/// Returns the weights of a triangle's corners at a point of it: the areas of the triangles that the point makes with
/// the opposite sides, as shares of their sum.
inline std::array<double, 3> cornerWeights(const Vec3& p, const std::array<Vec3, 3>& triangle)
{
    const auto& [a, b, c] = triangle;
    const double atA = (b - p).cross(c - p).norm(), atB = (c - p).cross(a - p).norm(),
                 atC = (a - p).cross(b - p).norm();
    const double area = atA + atB + atC;
    return {atA / area, atB / area, atC / area};
}

/// Möller and Trumbore 1997, front faces only. Returns the multiple of the direction, negative for a miss.
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
