#include "core/stroke/stroke_path.h"

#include "core/stroke/stroke_anchor.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace core
{
namespace
{
/// Smallest spacing of Stamp's dabs, in radii. Overlapping stamps would press into each other's imprints and go ever
/// deeper.
constexpr double minStampSpacing = 2;
/// If the part of a unit direction perpendicular to `up` has a smaller squared length, it may be a rounding error.
constexpr double minAcross2 = 1e-12;

/// Returns the unit direction of the part of `way` perpendicular to `up`; any perpendicular direction if `way` is
/// parallel to `up`.
Vec3 acrossUp(const Vec3& way, const Vec3& up)
{
    const Vec3 across = way - way.dot(up) * up;
    return across.squaredNorm() > minAcross2 * way.squaredNorm() ? Vec3(across.normalized())
                                                                 : Vec3(up.unitOrthogonal());
}
} // namespace

void StrokePath::add(const StrokeSample& sample)
{
    (m_target ? m_after : m_target) = sample;
    if (isAnchored(m_settings)) // keeps the largest pressure, because a pen's pressure fades while it is lifted
        m_target->pressure = std::max(m_target->pressure, sample.pressure);
    m_dabsLeft.reset();
}

std::optional<StrokePath::Due> StrokePath::next(const CenterOf& centerOf)
{
    if (isAnchored(m_settings))
        return nextAnchored(centerOf);
    while (true) {
        if (const std::optional<Due> resting = nextResting(centerOf))
            return resting;
        if (!m_target)
            return std::nullopt;
        const Due end = due(*m_target, centerOf);
        const bool everySample = m_settings.spacing == 0;
        if (everySample || !m_center || !end.hasCenter) {
            const bool isTooNear =
                !everySample && m_stamped && end.hasCenter && (end.dab.position - *m_stamped).norm() < stepOf(end.dab);
            const bool dabDue = everySample || (end.hasCenter && !isTooNear);
            if (m_settings.tool == Tool::Stamp && dabDue)
                m_stamped = end.dab.position;
            if (dabDue)
                m_rest.follow(end.dab, end.hand, m_target->time);
            arriveAtTarget(end);
            if (dabDue)
                return end;
        } else if (m_settings.tool == Tool::Stamp) {
            if (const std::optional<Due> stamp = nextStamp(end, centerOf))
                return stamp;
        } else if (m_rest.isAtRest(end.dab, end.hand)) {
            // the distance travelled is kept, so that slow motion also leads to the next dab
            const auto [center, travelled] = std::pair(m_center, m_travelled);
            arriveAtTarget(end);
            m_center = center;
            m_travelled = travelled;
        } else if (isWaiting()) {
            return std::nullopt;
        } else if (const std::optional<Due> dab = nextOnCurve(end, centerOf)) {
            return dab;
        }
    }
}

/// Returns the single dab of an anchored stroke, once the stroke is finished.
std::optional<StrokePath::Due> StrokePath::nextAnchored(const CenterOf& centerOf)
{
    if (!m_isFinished || !m_target)
        return std::nullopt;
    Due result = due(*std::exchange(m_target, std::nullopt), centerOf);
    if (m_after && result.hasCenter)
        dragOut(result, *m_after);
    return result;
}

/// Sets the dab's radius and up direction from the displacement between its sample and the last one. A ray is turned
/// into a displacement as for a drag tool (StrokeAnchor::placeOf()).
void StrokePath::dragOut(Due& due, const StrokeSample& last) const
{
    const Eigen::Quaterniond inverse = last.rotation.conjugate();
    const Vec3 hand = inverse * last.position;
    Vec3 way = hand - due.hand;
    if (isByRay(m_settings)) {
        StrokeAnchor anchor(m_settings);
        anchor.place(due.dab);
        const std::optional<Vec3> place = anchor.placeOf(hand, inverse * last.direction);
        way = place ? Vec3(*place - due.dab.position) : Vec3(Vec3::Zero());
    }
    if (!(way.norm() > minDragged * due.dab.radius))
        return;
    const ParameterInfo& range = info(Parameter::Radius);
    due.dab.radius = std::clamp(way.norm(), range.min, range.max);
    due.dab.up = way.normalized();
    due.dab.ahead = acrossUp(due.dab.direction, due.dab.up);
}

/// Returns an airbrush dab at the pointer's rest position, if one is due.
std::optional<StrokePath::Due> StrokePath::nextResting(const CenterOf& centerOf)
{
    if (!(m_settings.airbrush > 0) || !m_from)
        return std::nullopt;
    Due result = due(m_from->sample, centerOf);
    if (!result.hasCenter || !m_rest.takeDab(result.dab, result.hand, m_from->sample.time))
        return std::nullopt;
    result.isResting = true;
    m_travelled = 0;
    return result;
}

/// Returns the next dab on the way to the target. If there is none before the target, makes the target the start of the
/// next segment and returns nothing.
std::optional<StrokePath::Due> StrokePath::nextOnCurve(const Due& end, const CenterOf& centerOf)
{
    const double step = stepOf(end.dab);
    const double segment = (end.dab.position - *m_center).norm();
    if (!m_dabsLeft) {
        m_dabsLeft =
            static_cast<int>(std::min(maxLengthRatio * (m_travelled + segment) / step, double(maxDabsPerSample)));
        m_curve = curveTo(end, centerOf);
        m_at = 0;
    }
    if (m_travelled + segment < step || m_dabsLeft == 0) {
        const double travelled = m_travelled + segment;
        arriveAtTarget(end);
        m_travelled = std::min(travelled, step);
        return std::nullopt;
    }
    --*m_dabsLeft;
    const double part = segment > 0 ? (step - m_travelled) / segment : 1;
    const Vec3 between = *m_center + part * (end.dab.position - *m_center);
    m_at += part * (1 - m_at);
    const StrokeSample sample = m_curve.at(m_at);
    const Due result = due(sample, centerOf);
    m_rest.follow(result.dab, result.hand, sample.time);
    m_center = result.hasCenter ? result.dab.position : between;
    m_travelled = 0;
    return result;
}

SampleCurve StrokePath::curveTo(const Due& end, const CenterOf& centerOf) const
{
    const PlacedSample target = {*m_target, end.dab.position};
    if (m_before || !m_after)
        return {*m_from, target, m_before ? &*m_before : nullptr, nullptr};
    const Due next = due(*m_after, centerOf);
    const PlacedSample after = {*m_after, next.dab.position};
    return {*m_from, target, nullptr, next.hasCenter ? &after : nullptr};
}

/// Returns the distance between this dab and the next, in mm.
double StrokePath::stepOf(const Dab& dab) const
{
    return (m_settings.tool == Tool::Stamp ? std::max(m_settings.spacing, minStampSpacing) : m_settings.spacing) *
           dab.radius;
}

/// Returns the next stamp: where the straight line to `end` leaves the ball of radius stepOf() around the previous
/// stamp. A path along the surface would lead down into that stamp's imprint.
std::optional<StrokePath::Due> StrokePath::nextStamp(const Due& end, const CenterOf& centerOf)
{
    const double step = stepOf(end.dab);
    const Vec3 from = *m_center - m_stamped.value_or(*m_center), way = end.dab.position - *m_center;
    if (!m_dabsLeft)
        m_dabsLeft = static_cast<int>(std::min(1 + maxLengthRatio * way.norm() / step, double(maxDabsPerSample)));
    if ((from + way).norm() < step || m_dabsLeft == 0) {
        arriveAtTarget(end);
        return std::nullopt;
    }
    --*m_dabsLeft;
    const double along = from.dot(way), length2 = way.squaredNorm(), inside = step * step - from.squaredNorm();
    const double t = inside > 0 ? (std::sqrt(along * along + length2 * inside) - along) / length2 : 0;
    const Vec3 between = *m_center + t * way;
    m_from = {SampleCurve(*m_from, {*m_target, end.dab.position}, nullptr, nullptr).at(std::min(t, 1.0)), between};
    const Due result = due(m_from->sample, centerOf);
    m_stamped = m_center = result.hasCenter ? result.dab.position : between;
    return result;
}

void StrokePath::arriveAtTarget(const Due& due)
{
    m_before = due.hasCenter ? m_from : std::nullopt;
    m_center = due.hasCenter ? std::optional(due.dab.position) : std::nullopt;
    m_from = due.hasCenter ? std::optional(PlacedSample{*m_target, due.dab.position}) : std::nullopt;
    m_target = std::exchange(m_after, std::nullopt);
    m_dabsLeft.reset();
    m_travelled = 0;
}

StrokePath::Due StrokePath::due(const StrokeSample& sample, const CenterOf& centerOf) const
{
    const Eigen::Quaterniond inverse = sample.rotation.conjugate();
    const Vec3 position = inverse * sample.position, direction = inverse * sample.direction;
    const std::optional<Vec3> center = centerOf(position, direction);
    Due result;
    result.hasCenter = center.has_value();
    result.dab.position = center.value_or(position);
    result.hand = position;
    result.dab.direction = direction;
    result.dab.up = inverse * Vec3::UnitY();
    result.dab.ahead = inverse * -Vec3::UnitZ();
    if (sample.up) {
        result.dab.up = (inverse * *sample.up).normalized();
        result.dab.ahead = acrossUp(direction, result.dab.up);
    }
    result.dab.radius = sample.radius.value_or(m_settings.radius);
    result.dab.strength = sample.strength.value_or(m_settings.strength) * sample.pressure;
    return result;
}
} // namespace core
