#include "core/stroke/stroke_anchor.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace core
{
namespace
{
/// Largest turn of a Twist dab, in radians, because its vertices move along straight lines. A motion by one radius
/// turns by one radian.
constexpr double maxTurn = 1;
/// A ray is intersected with the plane only if the cosine of its angle to the normal is larger. With a flatter ray, a
/// small tremor would move the intersection by kilometres.
constexpr double minAcross = 0.05;
/// Largest motion of a dab, in radii.
constexpr double maxMotion = 0.1;
/// Largest number of dabs for one motion. A longer motion has longer dabs.
constexpr double maxParts = 20;
} // namespace

std::optional<Vec3> StrokeAnchor::placeOf(const Vec3& position, const Vec3& direction) const
{
    if (!isByRay(m_settings))
        return position + m_offset;
    const Vec3& normal = m_anchor->direction;
    const double across = direction.dot(normal);
    if (!(across > minAcross * direction.norm() * normal.norm()))
        return std::nullopt;
    return position + (m_anchor->position - position).dot(normal) / across * direction;
}

std::vector<Dab> StrokeAnchor::divide(const Dab& dab) const
{
    const Vec3 motion = dab.position - m_last;
    constexpr double rounding = 1e-6; // a motion of maxMotion is not divided because of it
    const double wanted = std::ceil(motion.norm() / (maxMotion * dab.radius) - rounding);
    const double parts = isSet() ? std::clamp(wanted, 1.0, maxParts) : 1;
    std::vector<Dab> dabs(static_cast<std::size_t>(parts), dab);
    for (std::size_t i = 0; i + 1 < dabs.size(); ++i)
        dabs[i].position = m_last + static_cast<double>(i + 1) / parts * motion;
    return dabs;
}

void StrokeAnchor::place(Dab& dab)
{
    if (!m_anchor) {
        m_anchor = {dab.position, dab.direction};
        m_last = m_tip = dab.position;
        if (m_settings.tool == Tool::SnakeHook)
            m_offset = dab.position - m_hand;
        return;
    }
    dab.motion = dab.position - std::exchange(m_last, dab.position);
    if (keepsSelection(m_settings.tool))
        dab.position = m_anchor->position;
    if (m_settings.tool == Tool::SnakeHook) {
        dab.position = m_tip;
        dab.heading = m_heading;
        dab.way = (m_tip - m_anchor->position).norm();
        m_heading = headingAfter(dab);
    }
    if (m_settings.tool == Tool::Twist)
        dab.turn = turnBy(dab);
}

/// Returns the angle, in radians, by which the dab turns. Motion along the stroke's first motion turns one way, motion
/// back turns the other way. If the first motion was to the right (seen along the first direction, Y up), the turn is
/// anticlockwise.
double StrokeAnchor::turnBy(const Dab& dab)
{
    if (m_pulled.isZero() && !dab.motion.isZero()) {
        m_pulled = dab.motion.normalized();
        const Vec3 right = m_anchor->direction.cross(Vec3::UnitY());
        m_sense = m_pulled.dot(right) < 0 ? -1 : 1;
    }
    const double turn = m_sense * dab.motion.dot(m_pulled) / dab.radius;
    return std::clamp(m_settings.inverted ? -turn : turn, -maxTurn, maxTurn);
}

void StrokeAnchor::follow(const Dab& dab, const DabReport& report)
{
    if (m_settings.tool == Tool::SnakeHook && report.asked > 0)
        m_tip += std::min(report.reached / report.asked, 1.0) * dab.motion;
}
} // namespace core
