#pragma once

#include "core/sculpt/deform/dab_frame.h"
#include "core/sculpt/deform/stamp_shape.h"

namespace core
{
/// A dab's share of each vertex of its region: b(x) of the distance times the alpha's shade, for tools that use one; of
/// Stamp 1 inside of the brush's model, else 0. Refers to what it was made of.
class DabWeights
{
public:
    DabWeights(const Region& region, const Mesh& mesh, const StrokeSettings& settings, const Dab& dab);

    /// Precondition: the region holds v.
    double of(Slot v) const
    {
        const Vec3 p = m_mesh.point(v).cast<double>();
        if (m_stamp)
            return m_region.carried(v) == 0 && m_stamp->depthAt(p) != 0 ? 1 : 0;
        return at(p, m_region.distance(v));
    }

private:
    double at(const Vec3& p, double distance) const;

    const Region& m_region;
    const Mesh& m_mesh;
    const StrokeSettings& m_settings;
    const Dab& m_dab;
    const Alpha* m_alpha; ///< or none
    DabFrame m_frame;
    std::optional<StampShape> m_stamp;
};
} // namespace core
