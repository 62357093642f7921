#include "core/geometry/triangle_distance.h"

#include "core/geometry/point_triangle.h"

#include <algorithm>

namespace core
{
namespace
{
void keepNearer(NearestPair& nearest, const Vec3& a, const Vec3& b)
{
    const double squaredDistance = (a - b).squaredNorm();
    if (squaredDistance < nearest.squaredDistance)
        nearest = {a, b, squaredDistance};
}

/// Clips the range [from, to] of a segment's parameter to where a height that is linear along the segment is >= 0.
void clip(double atStart, double atEnd, double& from, double& to)
{
    const double change = atEnd - atStart;
    if (change > 0)
        from = std::max(from, -atStart / change);
    else if (change < 0)
        to = std::min(to, -atStart / change);
    else if (atStart < 0)
        to = -1;
}

/// Finds a point that is in both triangles, if b crosses the plane of a. The plane cuts a segment from b; this segment
/// is clipped by the sides of a.
bool commonPoint(const std::array<Vec3, 3>& a, const std::array<Vec3, 3>& b, Vec3& common)
{
    const Vec3 normal = (a[1] - a[0]).cross(a[2] - a[0]);
    std::array<double, 3> height;
    for (std::size_t i = 0; i < 3; ++i)
        height[i] = normal.dot(b[i] - a[0]);
    if (*std::ranges::min_element(height) > 0 || *std::ranges::max_element(height) < 0)
        return false;
    std::array<Vec3, 2> ends;
    std::size_t count = 0;
    for (std::size_t i = 0; i < 3 && count < 2; ++i) {
        const std::size_t j = (i + 1) % 3;
        if ((height[i] < 0) != (height[j] < 0))
            ends[count++] = b[i] + height[i] / (height[i] - height[j]) * (b[j] - b[i]);
    }
    if (count < 2)
        return false;
    double from = 0, to = 1;
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec3 inward = normal.cross(a[(i + 1) % 3] - a[i]);
        clip(inward.dot(ends[0] - a[i]), inward.dot(ends[1] - a[i]), from, to);
    }
    if (from > to)
        return false;
    common = ends[0] + (from + to) / 2 * (ends[1] - ends[0]);
    return true;
}
} // namespace

NearestPair nearestOfSegments(const Vec3& a0, const Vec3& a1, const Vec3& b0, const Vec3& b1)
{
    const Vec3 a = a1 - a0, b = b1 - b0, between = a0 - b0;
    const double aa = a.squaredNorm(), bb = b.squaredNorm(), ab = a.dot(b), ca = a.dot(between), cb = b.dot(between);
    const double determinant = aa * bb - ab * ab;
    const auto share = [](double part, double whole) { return whole > 0 ? std::clamp(part / whole, 0.0, 1.0) : 0; };
    double s = share(ab * cb - ca * bb, determinant);
    const double t = share(ab * s + cb, bb);
    s = share(ab * t - ca, aa); // computed again, because t may have been clamped to an end of its segment
    const Vec3 p = a0 + s * a, q = b0 + t * b;
    return {p, q, (p - q).squaredNorm()};
}

NearestPair nearestOfTriangleAndSegment(const std::array<Vec3, 3>& a, const Vec3& b0, const Vec3& b1)
{
    NearestPair nearest;
    if (Vec3 common; commonPoint(a, {b0, b1, b1}, common))
        return {common, common, 0};
    keepNearer(nearest, nearestInTriangle(b0, a), b0);
    keepNearer(nearest, nearestInTriangle(b1, a), b1);
    for (std::size_t i = 0; i < 3; ++i) {
        const NearestPair pair = nearestOfSegments(a[i], a[(i + 1) % 3], b0, b1);
        keepNearer(nearest, pair.a, pair.b);
    }
    return nearest;
}

NearestPair nearestOfTriangles(const std::array<Vec3, 3>& a, const std::array<Vec3, 3>& b)
{
    NearestPair nearest;
    if (Vec3 common; commonPoint(a, b, common))
        return {common, common, 0};
    for (std::size_t i = 0; i < 3; ++i) {
        keepNearer(nearest, a[i], nearestInTriangle(a[i], b));
        keepNearer(nearest, nearestInTriangle(b[i], a), b[i]);
        for (std::size_t j = 0; j < 3; ++j) {
            const NearestPair pair = nearestOfSegments(a[i], a[(i + 1) % 3], b[j], b[(j + 1) % 3]);
            keepNearer(nearest, pair.a, pair.b);
        }
    }
    return nearest;
}
} // namespace core
