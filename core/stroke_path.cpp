#include "stroke_path.h"

#include <algorithm>

namespace core
{
namespace
{
/// Stamps of a stroke stand beside each other: one in another's imprint would go ever deeper.
constexpr double leastStampSpacing = 2;

/// Between two samples; everything but the rotation is linear. The rotation is the later one's: samples are dense.
StrokeSample interpolate(const StrokeSample& a, const StrokeSample& b, double t)
{
    const auto mix = [t](double x, double y) { return x + t * (y - x); };
    StrokeSample s = b;
    s.time = mix(a.time, b.time);
    s.position = a.position + t * (b.position - a.position);
    s.direction = a.direction + t * (b.direction - a.direction);
    s.pressure = mix(a.pressure, b.pressure);
    if (a.radius && b.radius)
        s.radius = mix(*a.radius, *b.radius);
    if (a.strength && b.strength)
        s.strength = mix(*a.strength, *b.strength);
    return s;
}
} // namespace

void StrokePath::add(const StrokeSample& sample)
{
    m_target = sample;
    m_dabsLeft.reset();
}

std::optional<StrokePath::Due> StrokePath::next(const CenterOf& centerOf)
{
    if (!m_target)
        return std::nullopt;
    const Due end = due(*m_target, centerOf);
    const bool everySample = m_settings.spacing == 0;
    if (everySample || !m_center || !end.hasCenter) {
        const bool dabDue = everySample || end.hasCenter;
        m_stamped = end.dab.position;
        const Due arrived = arriveAtTarget(end);
        return dabDue ? std::optional(arrived) : std::nullopt;
    }
    if (m_settings.tool == Tool::Stamp)
        return nextStamp(end);
    const double step = m_settings.spacing * end.dab.radius;
    const double segment = (end.dab.position - *m_center).norm();
    if (!m_dabsLeft)
        m_dabsLeft = static_cast<int>(std::min(mostTimesLonger * (m_travelled + segment) / step, double(mostDabsPerSample)));
    if (m_travelled + segment < step || m_dabsLeft == 0) {
        const double travelled = m_travelled + segment;
        arriveAtTarget(end);
        m_travelled = std::min(travelled, step);
        return std::nullopt;
    }
    --*m_dabsLeft;
    const double t = segment > 0 ? (step - m_travelled) / segment : 1;
    const Vec3 between = *m_center + t * (end.dab.position - *m_center);
    m_at = interpolate(m_at, *m_target, t);
    const Due result = due(m_at, centerOf);
    m_center = result.hasCenter ? result.dab.position : between;
    m_travelled = 0;
    return result;
}

/// By the straight way from the one before: the path itself goes down into what that has pressed in.
std::optional<StrokePath::Due> StrokePath::nextStamp(const Due& end)
{
    const Due arrived = arriveAtTarget(end);
    if ((end.dab.position - m_stamped).norm() < std::max(m_settings.spacing, leastStampSpacing) * end.dab.radius)
        return std::nullopt;
    m_stamped = end.dab.position;
    return arrived;
}

StrokePath::Due StrokePath::arriveAtTarget(const Due& due)
{
    m_at = *m_target;
    m_target.reset();
    m_center = due.hasCenter ? std::optional(due.dab.position) : std::nullopt;
    m_travelled = 0;
    return due;
}

StrokePath::Due StrokePath::due(const StrokeSample& sample, const CenterOf& centerOf) const
{
    const Eigen::Quaterniond inverse = sample.rotation.conjugate();
    const Vec3 position = inverse * sample.position, direction = inverse * sample.direction;
    const std::optional<Vec3> center = centerOf(position, direction);
    Due result;
    result.hasCenter = center.has_value();
    result.dab.position = center.value_or(position);
    result.dab.direction = direction;
    result.dab.up = inverse * Vec3::UnitY();
    result.dab.ahead = inverse * -Vec3::UnitZ();
    result.dab.radius = sample.radius.value_or(m_settings.radius);
    result.dab.strength = sample.strength.value_or(m_settings.strength) * sample.pressure;
    return result;
}
} // namespace core
