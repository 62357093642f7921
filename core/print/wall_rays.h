#pragma once

#include "core/print/wall_surface.h"

namespace core
{
/// Casts rays through the matter within a surface.
class WallRays
{
public:
    /// Keeps a reference to the surface.
    explicit WallRays(const WallSurface& surface) : m_surface(surface) {}

    /// Returns the diameter of the least ball that five rays find: one along the normal, and four around it unless the
    /// first finds more than `largest`. Returns infinity if no opposite face is hit.
    double byRays(Slot position, const Vec3& p, double largest) const;
    /// Returns the depth of the matter at p along the normal; 0 if no face is hit.
    double depthBehind(Slot position, const Vec3& p) const;
    /// Returns whether no face is between the point p of a face and another point q of the surface.
    bool isInSight(Slot position, const Vec3& p, const Vec3& q) const;
    /// Returns whether no face is between two points of the surface that see each other through the matter.
    bool areInSight(const Vec3& p, const Vec3& q) const;

private:
    struct Hit
    {
        Slot position = noSlot;
        double distance = noBall; ///< in multiples of the direction's length
    };

    Hit firstHit(Slot from, const Vec3& origin, const Vec3& direction, double farthest) const;
    double ballOfRay(Slot position, const Vec3& origin, const Vec3& direction, double largest) const;

    const WallSurface& m_surface;
};
} // namespace core
