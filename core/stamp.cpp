#include "stamp.h"

#include "brush_model.h"

#include <algorithm>
#include <cmath>

namespace core
{
namespace
{
std::optional<BrushModel::Span> spanOfBall(const Vec3& p)
{
    if (p.squaredNorm() >= 1)
        return std::nullopt;
    const double top = std::sqrt(1 - p.x() * p.x() - p.z() * p.z());
    return BrushModel::Span{-top, top};
}
} // namespace

Stamp::Stamp(const DabFrame& frame, const StrokeSettings& settings, const Dab& dab)
    : m_frame(frame), m_model(settings.model.get()), m_center(dab.position), m_radius(dab.radius), m_share(std::min(dab.strength, 1.0)),
      m_raises(settings.inverted)
{
}

double Stamp::way(const Vec3& p) const
{
    const Vec3 r = (p - m_center) / m_radius;
    const Vec3 at(r.dot(m_frame.right), r.dot(m_frame.normal), -r.dot(m_frame.up));
    const auto span = m_model ? m_model->spanAt(at) : spanOfBall(at);
    return span ? ((m_raises ? span->high : span->low) - at.y()) * m_radius : 0;
}
} // namespace core
