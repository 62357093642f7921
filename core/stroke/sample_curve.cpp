#include "core/stroke/sample_curve.h"

#include <cmath>

namespace core
{
namespace
{
/// Cosine of the largest angle by which a curve may turn at a sample. A larger angle counts as a corner.
constexpr double cornerCosine = 0.5;
/// Largest ratio of the longer to the shorter of the two distances between three successive samples. Beyond it the
/// parabola would overshoot.
constexpr double maxRatio = 8;

/// Returns the bend, between p1 and p2, of the parabola through p0, p1 and p2, which are at t = -ratio, 0 and 1.
Vec3 bend(const Vec3& p0, const Vec3& p1, const Vec3& p2, double ratio)
{
    return ((p1 - p0) / ratio - (p2 - p1)) / (1 + ratio);
}

/// Interpolates between two rotations along the shorter arc. Uses no trigonometric functions, because their last bits
/// differ between machines.
Eigen::Quaterniond between(const Eigen::Quaterniond& a, const Eigen::Quaterniond& b, double t)
{
    const Eigen::Vector4d end = a.dot(b) < 0 ? Eigen::Vector4d(-b.coeffs()) : b.coeffs();
    return Eigen::Quaterniond(Eigen::Vector4d(a.coeffs() + t * (end - a.coeffs()))).normalized();
}
} // namespace

SampleCurve::SampleCurve(const PlacedSample& from, const PlacedSample& to, const PlacedSample* before,
                         const PlacedSample* after)
    : m_from(from.sample)
    , m_to(to.sample)
{
    const PlacedSample* const beside = before ? before : after;
    if (!beside)
        return;
    // `from` and `to` may be exchanged: the bend of the parabola is the same in both directions
    const PlacedSample &near = before ? from : to, &far = before ? to : from;
    const Vec3 first = near.center - beside->center, second = far.center - near.center;
    const double length = second.norm(), ratio = length > 0 ? first.norm() / length : 0;
    if (!(ratio * maxRatio > 1 && ratio < maxRatio && first.dot(second) > cornerCosine * first.norm() * length))
        return;
    m_bend = bend(beside->sample.position, near.sample.position, far.sample.position, ratio);
    m_directionBend = bend(beside->sample.direction, near.sample.direction, far.sample.direction, ratio);
}

StrokeSample SampleCurve::at(double t) const
{
    const auto mix = [t](double x, double y) { return x + t * (y - x); };
    const StrokeSample &a = m_from, &b = m_to;
    StrokeSample s = b;
    s.time = mix(a.time, b.time);
    s.position = a.position + t * (b.position - a.position) + t * (1 - t) * m_bend;
    s.direction = a.direction + t * (b.direction - a.direction) + t * (1 - t) * m_directionBend;
    s.rotation = between(a.rotation, b.rotation, t);
    s.pressure = mix(a.pressure, b.pressure);
    if (a.radius && b.radius)
        s.radius = mix(*a.radius, *b.radius);
    if (a.strength && b.strength)
        s.strength = mix(*a.strength, *b.strength);
    return s;
}
} // namespace core
