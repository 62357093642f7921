#pragma once

#include "core/sculpt/deform/dab_frame.h"

namespace core
{
/// The brush's model, or a ball, on the surface: its middle at the dab's centre, its y along the surface's normal, its
/// bounding radius the brush's. What of the surface lies inside of it sinks to its lower side along the normal, or
/// inverted rises to its upper one.
class StampShape
{
public:
    StampShape(const DabFrame& frame, const StrokeSettings& settings, const Dab& dab);

    /// How far p is to go along the normal; 0 outside.
    double way(const Vec3& p) const;
    /// The mean of that over the square of half side `reach` around p, as a vector and as far as the strength goes: all
    /// the way at most. So an outline is as smooth as a mesh whose edges are that long can show it.
    Vec3 field(const Vec3& p, double reach) const;

private:
    DabFrame m_frame;
    const BrushModel* m_model; ///< null: a ball
    Vec3 m_center;
    double m_radius, m_share;
    bool m_raises;
};
} // namespace core
