#pragma once

#include "core/geometry/triangle_mesh.h"
#include "core/sculpt/deform/dab_frame.h"

namespace core
{
/// The brush's model, or a ball, on the surface: its middle is the dab's centre, its y axis the surface's normal, its
/// bounding radius the brush's. The part of the surface inside of it sinks to its lower side along the normal, or
/// inverted rises to its upper side.
class StampShape
{
public:
    StampShape(const DabFrame& frame, const StrokeSettings& settings, const Dab& dab);

    /// Returns the signed distance along the frame's normal from p to the side of the stamp that the surface takes, in
    /// mm: negative where the surface sinks, 0 outside the stamp.
    double depthAt(const Vec3& p) const;
    /// Returns the displacement of p, in mm: the mean of depthAt() over the square of half side `reach` around p, times
    /// the strength, at most 1. The mean makes the outline as smooth as edges of that length can show it; with 0 for
    /// `reach` it is depthAt() alone.
    Vec3 field(const Vec3& p, double reach) const;
    /// Returns the stamp as a solid, flattened along the normal by the strength, with edges of about that length if it
    /// is a ball, and in `places` where its points are, in mm.
    TriangleMesh solid(double edge, std::vector<Vec3>& places) const;

private:
    DabFrame m_frame;
    const BrushModel* m_model; ///< null: a ball
    Vec3 m_center;
    double m_radius, m_share;
    bool m_raises;
};
} // namespace core
