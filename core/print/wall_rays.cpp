#include "core/print/wall_rays.h"

#include "core/geometry/point_triangle.h"

namespace core
{
namespace
{
/// Tangent of the angle, 30 degrees, between the normal and the rays around it.
constexpr double coneTangent = 0.57735026918962576;
/// Distance by which lines of sight begin and end inside the surface, as a share of their length.
constexpr double endInset = 1e-3;
} // namespace

/// Returns the first face through which the ray leaves the matter.
WallRays::Hit WallRays::firstHit(Slot from, const Vec3& origin, const Vec3& direction, double farthest) const
{
    Hit hit{noSlot, farthest};
    const Ray ray{origin, direction};
    const double length = direction.norm();
    m_surface.tree().forEachNear(WallTree::Ray(m_surface.tree(), origin, direction), farthest, [&](Slot position) {
        if (position == from || !m_surface.mayLeave(position, ray, length, hit.distance))
            return hit.distance;
        // Reversed, seen from within: entering through a face is no hit
        const auto [a, c, b] = m_surface.cornersOf(position);
        const double distance = hitTriangle(ray, {a, b, c});
        if (distance >= 0 && distance < hit.distance)
            hit = {position, distance};
        return hit.distance;
    });
    return hit;
}

/// Casts rays whose component along the normal is 1: a hit at t gives a ball with the diameter t (1 + tan^2).
double WallRays::byRays(Slot position, const Vec3& p, double largest) const
{
    static constexpr std::array<std::array<double, 2>, 4> around = {{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
    const Vec3 inward = m_surface.inwardOf(position);
    double diameter = ballOfRay(position, p, inward, noBall);
    if (diameter > largest && diameter < noBall)
        return diameter;
    const Vec3 x = inward.unitOrthogonal(), y = inward.cross(x);
    for (const auto& [along, across] : around) {
        const Vec3 direction = inward + coneTangent * (along * x + across * y);
        diameter = std::min(diameter, ballOfRay(position, p, direction, std::min(diameter, largest)));
    }
    return diameter;
}

double WallRays::ballOfRay(Slot position, const Vec3& origin, const Vec3& direction, double largest) const
{
    const double perDistance = direction.squaredNorm();
    const Hit hit = firstHit(position, origin, direction, largest / perDistance);
    const bool isWall = hit.position != noSlot && m_surface.areOpposite(position, hit.position);
    return isWall ? hit.distance * perDistance : noBall;
}

double WallRays::depthBehind(Slot position, const Vec3& p) const
{
    const Hit hit = firstHit(position, p, m_surface.inwardOf(position), noBall);
    return hit.position == noSlot ? 0 : hit.distance;
}

bool WallRays::isInSight(Slot position, const Vec3& p, const Vec3& q) const
{
    constexpr double beforeIt = 1 - 1e-6;
    return firstHit(position, p, q - p, beforeIt).position == noSlot;
}

bool WallRays::areInSight(const Vec3& p, const Vec3& q) const
{
    const Vec3 step = endInset * (q - p);
    return firstHit(noSlot, p + step, q - p - 2 * step, 1).position == noSlot;
}
} // namespace core
