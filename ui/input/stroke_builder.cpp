#include "ui/input/stroke_builder.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>
#include <utility>

namespace ui
{
namespace
{
constexpr double minPressureRadius = 0.1;             ///< fraction of the brush's radius at the lightest pressure
constexpr std::chrono::milliseconds restInterval(20); ///< interval of samples while the pointer does not move
} // namespace

StrokeBuilder::StrokeBuilder(const BrushSettings* brush, const OrbitCamera* camera, QObject* parent)
    : QObject(parent)
    , m_brush(brush)
    , m_camera(camera)
{
    m_rest.setInterval(restInterval);
    connect(&m_rest, &QTimer::timeout, this, &StrokeBuilder::rest);
}

void StrokeBuilder::begin(const Start& start)
{
    m_isOpen = true;
    m_settings = start.settings;
    m_stabilizerLength = start.stabilizerLength;
    m_pointer = start.pointer;
    m_brushAt = start.pointer.pixel;
    Q_EMIT began(start.settings);
    sample(start.ray);
    if (m_settings.airbrush > 0)
        m_rest.start();
}

/// Repeats the sample of a pointer that does not move, with the elapsed time added.
void StrokeBuilder::rest()
{
    if (m_sinceSample.elapsed() < restInterval.count())
        return;
    m_pointer.time += static_cast<double>(m_sinceSample.nsecsElapsed()) * 1e-9;
    sample(m_camera->ray(m_brushAt));
}

/// Moves the pointer. A steady brush is dragged behind it at the stabilizer's length.
void StrokeBuilder::moveTo(const PointerEvent& pointer, const core::Ray& ray)
{
    const double time = std::max(pointer.time, m_pointer.time); // repeated samples may be later than the event
    m_pointer = pointer;
    m_pointer.time = time;
    if (m_stabilizerLength == 0) {
        m_brushAt = pointer.pixel;
        return sample(ray);
    }
    const OrbitCamera::Pixel way = pointer.pixel - m_brushAt;
    if (way.norm() <= m_stabilizerLength)
        return;
    m_brushAt = pointer.pixel - way.normalized() * m_stabilizerLength;
    sample(m_camera->ray(m_brushAt));
}

void StrokeBuilder::setReleasePoint(const OrbitCamera::Pixel& pixel, double time)
{
    m_pointer.pixel = pixel;
    m_pointer.time = std::max(time, m_pointer.time);
}

void StrokeBuilder::end(core::StrokeEnd how)
{
    if (!std::exchange(m_isOpen, false))
        return;
    m_rest.stop();
    if (how == core::StrokeEnd::Kept && m_stabilizerLength > 0 && m_brushAt != m_pointer.pixel)
        sample(m_camera->ray(m_pointer.pixel));
    Q_EMIT ended(how);
}

void StrokeBuilder::turnModel(double angle, double seconds)
{
    m_turned = std::remainder(m_turned + angle, 2 * std::numbers::pi);
    if (!m_isOpen)
        return;
    m_pointer.time += seconds;
    sample(m_camera->ray(m_brushAt));
}

void StrokeBuilder::sample(const core::Ray& ray)
{
    core::StrokeSample sample;
    sample.time = m_pointer.time;
    sample.rotation = Eigen::AngleAxisd(m_turned, core::Vec3::UnitY());
    sample.position = sample.rotation * ray.origin;
    sample.direction = sample.rotation * ray.direction;
    const double pressure = penPressure(m_pointer.pressure, m_preferences.penExponent);
    sample.pressure = m_preferences.pressureToStrength ? pressure : 1;
    if (m_preferences.pressureToRadius)
        sample.radius = std::max(m_brush->minOf(core::Parameter::Radius),
                                 m_settings.radius * std::max(pressure, minPressureRadius));
    m_sinceSample.start();
    Q_EMIT sampled(sample);
}
} // namespace ui
