#include "core/stroke/resting_hand.h"

#include <algorithm>

namespace core
{
namespace
{
/// The hand rests if it is no farther than this from where it was at the last dab, in radii: one that follows a path
/// slowly is farther when the next dab is due.
constexpr double maxRestDistance = 0.05;
/// The first dab of a rest comes after this time, in seconds, so that a click is one dab.
constexpr double minRestSeconds = 0.25;
/// A longer rest between two samples counts as one of so many seconds: no hand is read so seldom.
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

/// A ray's hand is far from the surface: there a turn of the ray counts as well.
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
