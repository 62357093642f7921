#include "core/stroke/resting_hand.h"

#include <algorithm>

namespace core
{
namespace
{
/// Largest distance from the last dab, in radii, at which the pointer counts as at rest. A pointer that moves slowly is
/// farther away when the next dab is due.
constexpr double maxRestDistance = 0.05;
/// Shortest time at rest before the first airbrush dab, in seconds, so that a click makes only one dab.
constexpr double minRestSeconds = 0.25;
/// Longest time at rest between two samples, in seconds. Longer pauses count as this long: no device reports so rarely.
constexpr double maxRestSeconds = 10;
} // namespace

RestingHand::RestingHand(const StrokeSettings& settings)
    : m_rate(settings.spacing > 0 && canAirbrush(settings.tool) ? settings.airbrush : 0)
    , m_isRay(isByRay(settings))
{}

void RestingHand::follow(const Dab& dab, const Vec3& hand, double time)
{
    m_hasDab = m_rate > 0;
    m_isResting = false;
    m_hand = hand;
    m_direction = dab.direction.normalized();
    m_time = time;
}

/// The position of a ray's sample is far from the surface, so a rotation of the ray also counts as motion.
bool RestingHand::isAtRest(const Dab& dab, const Vec3& hand) const
{
    if (!m_hasDab)
        return false;
    double moved = (hand - m_hand).norm();
    if (m_isRay)
        moved += (dab.direction.normalized() - m_direction).norm() * (dab.position - hand).norm();
    return moved <= maxRestDistance * dab.radius;
}

bool RestingHand::takeDab(const Dab& dab, const Vec3& hand, double time)
{
    m_time = std::max(m_time, time - maxRestSeconds);
    if (!isAtRest(dab, hand) || time - m_time < interval())
        return false;
    const double next = m_time + interval();
    follow(dab, hand, next);
    m_isResting = true;
    return true;
}

double RestingHand::interval() const
{
    return m_isResting ? 1 / m_rate : std::max(1 / m_rate, minRestSeconds);
}
} // namespace core
