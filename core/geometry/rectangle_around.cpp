#include "core/geometry/rectangle_around.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <vector>

namespace core
{
namespace
{
using Vec2 = Eigen::Vector2d;

/// Returns the points projected onto the plane through their mean that fits them best.
std::vector<Vec2> flattened(std::span<const Vec3> points)
{
    Vec3 middle = Vec3::Zero();
    for (const Vec3& p : points)
        middle += p / static_cast<double>(points.size());
    Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
    for (const Vec3& p : points)
        spread += (p - middle) * (p - middle).transpose();
    const Eigen::Matrix3d axes = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread).eigenvectors();
    std::vector<Vec2> flat;
    for (const Vec3& p : points)
        flat.emplace_back(axes.col(1).dot(p - middle), axes.col(2).dot(p - middle));
    return flat;
}

/// Returns the corners of the convex hull, counter-clockwise (Andrew 1979).
std::vector<Vec2> convexHull(std::vector<Vec2> points)
{
    std::ranges::sort(points, {}, [](const Vec2& p) { return std::tuple(p.x(), p.y()); });
    std::vector<Vec2> hull;
    const auto turnsLeft = [&](const Vec2& p) {
        const Vec2 u = hull.back() - hull[hull.size() - 2], v = p - hull.back();
        return u.x() * v.y() - u.y() * v.x() > 0;
    };
    const auto add = [&](const auto& from) {
        const std::size_t first = hull.size();
        for (const Vec2& p : from) {
            while (hull.size() >= first + 2 && !turnsLeft(p))
                hull.pop_back();
            hull.push_back(p);
        }
        hull.pop_back(); // the other half begins with the same point
    };
    add(points);
    std::ranges::reverse(points);
    add(points);
    return hull;
}
} // namespace

Rectangle rectangleAround(std::span<const Vec3> points)
{
    const std::vector<Vec2> hull = convexHull(flattened(points));
    constexpr double rounding = 1e-6;
    Rectangle least;
    for (std::size_t i = 0; i < hull.size(); ++i) { // one side of the least rectangle is along an edge of the hull
        const Vec2 along = (hull[(i + 1) % hull.size()] - hull[i]).normalized(), across(-along.y(), along.x());
        Eigen::AlignedBox2d box;
        for (const Vec2& p : hull)
            box.extend(Vec2(along.dot(p), across.dot(p)));
        const Rectangle rectangle{box.sizes().maxCoeff(), box.sizes().minCoeff()};
        const double area = rectangle.length * rectangle.width, minArea = least.length * least.width;
        const bool isAsLarge = std::abs(area - minArea) <= rounding * minArea;
        if (i == 0 || (isAsLarge ? rectangle.length < least.length : area < minArea))
            least = rectangle;
    }
    return least;
}
} // namespace core
