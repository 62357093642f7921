#pragma once

#include "core/mesh/draw_arrays.h"

#include <vector>

namespace vr
{
/// Builds a closed triangle mesh, in metres. Triangles are counter-clockwise as seen from outside.
class SolidBuilder
{
public:
    using Loop = std::vector<core::Vec3>;

    /// Adds a surface through loops with the same number of points, from the first loop to the last. The first loop
    /// must be counter-clockwise as seen from outside the solid. Fans about the loops' middles close both ends.
    void loft(const std::vector<Loop>& loops);

    void add(const SolidBuilder& other);

    /// Returns the mesh with smooth normals, except at edges sharper than about 40 degrees. Triangles share a vertex
    /// where their normals agree. The vertices are white, because the shading's tint gives the colour.
    core::DrawArrays drawArrays() const;

private:
    core::Slot addPoint(const core::Vec3& point);

    std::vector<core::Vec3> m_points;
    std::vector<core::Triangle> m_faces;
};

/// Returns an ellipsoid. `half`: half axes along x, y and z, metres.
SolidBuilder ellipsoid(const core::Vec3& middle, const core::Vec3& half);

/// Heights of a plate with a bevelled upper edge, metres along +y. The outline of plate() is in x and z,
/// counter-clockwise as seen from above, and star-shaped about its middle.
struct PlateHeights
{
    double bottom = 0, top = 0, bevel = 0;
};
SolidBuilder plate(const SolidBuilder::Loop& outline, const PlateHeights& heights);
} // namespace vr
