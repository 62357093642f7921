#include "core/sculpt/deform/dab_weights.h"

#include "core/sculpt/deform/alpha.h"
#include "core/sculpt/deform/deform.h"

namespace core
{
DabWeights::DabWeights(const Region& region, const Mesh& mesh, const StrokeSettings& settings, const Dab& dab,
                       const Vec3& moved)
    : m_region(region)
    , m_mesh(mesh)
    , m_settings(settings)
    , m_dab(dab)
    , m_alpha(usesAlpha(settings.tool) ? settings.alpha.get() : nullptr)
{
    if (m_alpha || settings.tool == Tool::Stamp)
        m_frame = frameOn(region, mesh, settings, dab);
    if (settings.tool == Tool::Stamp)
        m_stamp.emplace(m_frame, settings, dab);
    if (settings.tool == Tool::Grab && !moved.isZero(0))
        m_push.emplace(region, mesh, settings, dab, moved);
}

double DabWeights::at(const Vec3& p, double distance) const
{
    const double weight = weightAt(distance, m_settings, m_dab);
    if (!m_alpha || weight == 0)
        return weight;
    const Vec3 r = (p - m_dab.position) / m_dab.radius;
    return weight * m_alpha->at(r.dot(m_frame.right), r.dot(m_frame.up));
}
} // namespace core
