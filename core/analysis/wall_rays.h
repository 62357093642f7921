#pragma once

#include "core/analysis/wall_surface.h"

namespace core
{
/// Casts rays through the matter within a surface.
class WallRays
{
public:
    /// Keeps a reference to the surface.
    explicit WallRays(const WallSurface& surface) : m_surface(surface) {}

    /// The least ball that one of five rays finds, one along the normal and, unless that says that it is thicker than
    /// `largest`, four around it. Infinity if no opposite face is hit.
    double byRays(Slot position, const Vec3& p, double largest) const;
    /// Returns the length of the matter along the normal; 0 if that cannot be told.
    double depthBehind(Slot position, const Vec3& p) const;
    /// Returns whether no face lies between a point of a face and another point of the surface.
    bool isInSight(Slot position, const Vec3& p, const Vec3& q) const;
    /// Returns whether no face lies between two points of the surface that see each other through the matter.
    bool areInSight(const Vec3& p, const Vec3& q) const;

private:
    struct Hit
    {
        Slot position = noSlot;
        double distance = noBall; ///< in the direction's length
    };

    Hit firstHit(Slot from, const Vec3& origin, const Vec3& direction, double farthest) const;
    double ballOfRay(Slot position, const Vec3& origin, const Vec3& direction, double largest) const;

    const WallSurface& m_surface;
};
} // namespace core
