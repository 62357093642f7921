#pragma once

#include "core/mesh/draw_arrays.h"

#include <vector>

namespace vr
{
/// Builds a closed triangle mesh, in metres. Counter-clockwise seen from outside.
class SolidBuilder
{
public:
    using Loop = std::vector<core::Vec3>;

    /// A skin over loops of equally many points, from the first, which is counter-clockwise seen from before it, to the
    /// last; both ends are closed by fans to their middles.
    void loft(const std::vector<Loop>& loops);

    void add(const SolidBuilder& other);

    /// Smooth, but for edges sharper than about 40 degrees. White: the shading's tint gives the colour.
    core::DrawArrays drawArrays() const;

private:
    core::Slot addPoint(const core::Vec3& point);

    std::vector<core::Vec3> m_points;
    std::vector<core::Triangle> m_faces;
};

/// Half axes of an ellipsoid along x, y and z.
SolidBuilder ellipsoid(const core::Vec3& middle, const core::Vec3& half);

/// A plate with a bevelled upper edge over an outline in x and z, which is counter-clockwise seen from above and all of
/// it seen from its middle. Upward is +y; `bottom` and `top` are heights.
struct PlateHeights
{
    double bottom = 0, top = 0, bevel = 0;
};
SolidBuilder plate(const SolidBuilder::Loop& outline, const PlateHeights& heights);
} // namespace vr
