#include "core/area/sight.h"

namespace core
{
namespace
{
/// Least ratio of a corner's depth to its distance from the eye: corners farther aside are refused.
constexpr double minCosine = 0.02;
} // namespace

Sight::Sight(const ViewArea& area) : m_isPerspective(area.eye.has_value())
{
    m_eye = area.eye.value_or(Vec3::Zero());
    Vec3 along = area.direction;
    along.stableNormalize();
    const Vec3 right = along.unitOrthogonal();
    m_axes << right, along.cross(right), along;
}

std::vector<Eigen::Vector2d> Sight::seenCurve(const std::vector<Vec3>& outline) const
{
    std::vector<Eigen::Vector2d> curve;
    for (const Vec3& p : outline) {
        const Vec3 at = seen(p);
        if (!at.allFinite() || (m_isPerspective && !(at.z() > minCosine * (p - m_eye).norm())))
            return {};
        curve.emplace_back(at.head<2>());
    }
    return curve;
}
} // namespace core
