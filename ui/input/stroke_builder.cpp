#include "ui/input/stroke_builder.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace ui
{
namespace
{
constexpr double leastRadiusShare = 0.1; ///< of the brush, under the lightest touch
} // namespace

StrokeMaker::StrokeMaker(const BrushSettings* brush, const OrbitCamera* camera, QObject* parent)
    : QObject(parent)
    , m_brush(brush)
    , m_camera(camera)
{}

void StrokeMaker::begin(const Start& start)
{
    m_isOpen = true;
    m_settings = start.settings;
    m_string = start.string;
    m_hand = start.hand;
    m_brushAt = start.hand.pixel;
    Q_EMIT began(start.settings);
    sample(start.ray);
}

/// The hand draws the brush behind it when the string is taut.
void StrokeMaker::follow(const PointerEvent& hand, const core::Ray& ray)
{
    m_hand = hand;
    if (m_string == 0) {
        m_brushAt = hand.pixel;
        return sample(ray);
    }
    const OrbitCamera::Pixel way = hand.pixel - m_brushAt;
    if (way.norm() <= m_string)
        return;
    m_brushAt = hand.pixel - way.normalized() * m_string;
    sample(m_camera->ray(m_brushAt));
}

void StrokeMaker::comeTo(const OrbitCamera::Pixel& pixel, double time)
{
    m_hand.pixel = pixel;
    m_hand.time = time;
}

void StrokeMaker::end()
{
    if (!std::exchange(m_isOpen, false))
        return;
    if (m_string > 0 && m_brushAt != m_hand.pixel)
        sample(m_camera->ray(m_hand.pixel));
    Q_EMIT ended();
}

void StrokeMaker::turnModel(double angle, double seconds)
{
    m_turned = std::remainder(m_turned + angle, 2 * std::numbers::pi);
    if (!m_isOpen)
        return;
    m_hand.time += seconds;
    sample(m_camera->ray(m_brushAt));
}

void StrokeMaker::sample(const core::Ray& ray)
{
    core::StrokeSample sample;
    sample.time = m_hand.time;
    sample.rotation = Eigen::AngleAxisd(m_turned, core::Vec3::UnitY());
    sample.position = sample.rotation * ray.origin;
    sample.direction = sample.rotation * ray.direction;
    const double pressure = penPressure(m_hand.pressure, m_habits.penExponent);
    sample.pressure = m_habits.pressureToStrength ? pressure : 1;
    if (m_habits.pressureToRadius)
        sample.radius =
            std::max(m_brush->minOf(core::Parameter::Radius), m_settings.radius * std::max(pressure, leastRadiusShare));
    Q_EMIT sampled(sample);
}

core::StrokeSettings addingDab(core::StrokeSettings settings)
{
    settings.tool = core::Tool::Pull;
    settings.brush = core::BrushShape::Sphere;
    settings.place = core::Placement::Point;
    settings.strength = core::info(core::Parameter::Strength).defaultValue;
    settings.spacing = 0;
    settings.add = true;
    return settings;
}
} // namespace ui
