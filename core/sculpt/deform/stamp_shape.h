#pragma once

#include "core/geometry/triangle_mesh.h"
#include "core/sculpt/deform/dab_frame.h"

namespace core
{
/// The shape of a stamp on the surface: the brush's model, or a ball. Its middle is at the dab's centre, its y axis
/// along the surface's normal, and its bounding radius is the brush's. The surface inside the shape is lowered along
/// the normal to the shape's lower side; if inverted, it is raised to the upper side.
class StampShape
{
public:
    StampShape(const DabFrame& frame, const StrokeSettings& settings, const Dab& dab);

    /// Returns the signed distance, in mm, along the frame's normal from p to the side of the shape that the surface is
    /// to take: negative where the surface sinks, 0 outside the shape.
    double depthAt(const Vec3& p) const;
    /// Returns the displacement of p, in mm: the mean of depthAt() over a square around p, times the strength (at most
    /// 1). `reach`: half the square's side, mm; 0: depthAt(p) alone. The mean makes the outline as smooth as a mesh
    /// with edges of that length can represent.
    Vec3 field(const Vec3& p, double reach) const;
    /// Returns the stamp as a solid, flattened along the normal by the strength. `edge`: approximate edge length if the
    /// shape is a ball, mm. `places` receives the positions of the solid's points, mm.
    TriangleMesh solid(double edge, std::vector<Vec3>& places) const;

private:
    DabFrame m_frame;
    const BrushModel* m_model;
    Vec3 m_center;
    double m_radius, m_share;
    bool m_raises;
};
} // namespace core
