#pragma once

#include "core/sculpt/deform/dab_frame.h"
#include "core/sculpt/deform/grab_push.h"
#include "core/sculpt/deform/stamp_shape.h"

namespace core
{
/// The weight of a dab at each vertex of its region: b(x) of the distance, times the alpha's shade for tools that use
/// an alpha. Stamp: 1 inside the brush's model, else 0. Grab: at least that of GrabPush. Keeps references to the
/// constructor's arguments.
class DabWeights
{
public:
    /// `moved`: the motion of a stroke of Grab so far, mm.
    DabWeights(const Region& region, const Mesh& mesh, const StrokeSettings& settings, const Dab& dab,
               const Vec3& moved = Vec3::Zero());

    /// Returns the weight of a vertex, 0 to 1. Precondition: the region contains v.
    double of(Slot v) const
    {
        const Vec3 p = m_mesh.point(v).cast<double>();
        if (m_stamp)
            return m_region.carried(v) == 0 && m_stamp->depthAt(p) != 0 ? 1 : 0;
        const double weight = at(p, m_region.distance(v));
        return m_push && m_push->held().contains(v) ? m_push->at(p, weight) : weight;
    }

private:
    double at(const Vec3& p, double distance) const;

    const Region& m_region;
    const Mesh& m_mesh;
    const StrokeSettings& m_settings;
    const Dab& m_dab;
    const Alpha* m_alpha; ///< null: no alpha
    DabFrame m_frame;
    std::optional<StampShape> m_stamp;
    std::optional<GrabPush> m_push;
};
} // namespace core
