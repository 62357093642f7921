#include "core/stroke/stroke.h"

#include <cmath>

namespace core
{
namespace
{
/// Length of recent motion, in radii, from which Snake Hook takes its heading.
constexpr double headingLength = 0.5;

bool isIn(double value, Parameter parameter)
{
    return value >= info(parameter).min && value <= info(parameter).max;
}

bool isNear(const Vec3& v)
{
    return (v.array().abs() <= maxSampleMagnitude).all();
}
} // namespace

StrokeSettings addingSolid(StrokeSettings settings)
{
    settings.tool = Tool::Pull;
    settings.brush = BrushShape::Sphere;
    settings.place = Placement::Point;
    settings.strength = info(Parameter::Strength).defaultValue;
    settings.spacing = 0;
    settings.anchored = false;
    settings.add = settings.join = true;
    return settings;
}

StrokeSettings opposite(StrokeSettings settings)
{
    if (settings.tool == Tool::Pull || settings.tool == Tool::Push)
        settings.tool = settings.tool == Tool::Pull ? Tool::Push : Tool::Pull;
    else if (hasInverse(settings.tool))
        settings.inverted = !settings.inverted;
    return settings;
}

Vec3 headingAfter(const Dab& dab)
{
    const Vec3 way = headingLength * dab.radius * dab.heading + dab.motion;
    const double length = way.norm();
    return length > 0 ? Vec3(way / length) : Vec3::Zero();
}

bool pushes(const StrokeSettings& settings)
{
    switch (settings.tool) {
    case Tool::Push:
    case Tool::Grab:
    case Tool::SnakeHook:
        return true;
    case Tool::Inflate:
    case Tool::Clay:
    case Tool::Layer:
        return settings.inverted;
    case Tool::Stamp:
        return !settings.inverted;
    default:
        return false;
    }
}

bool isUsable(const StrokeSettings& settings, const StrokeSample& sample)
{
    const bool settingsFit = isIn(settings.detail, Parameter::Detail) && isIn(settings.spacing, Parameter::Spacing) &&
                             isFalloff(settings.falloff) && settings.radial >= 1 && settings.radial <= maxRadial &&
                             settings.airbrush >= 0 && settings.airbrush <= maxAirbrush &&
                             (settings.detailLength == 0 || isIn(settings.detailLength, Parameter::Radius));
    return settingsFit && isIn(sample.radius.value_or(settings.radius), Parameter::Radius) &&
           isIn(sample.strength.value_or(settings.strength), Parameter::Strength) && sample.pressure >= 0 &&
           sample.pressure <= 1 && isNear(sample.position) && isNear(sample.direction) &&
           std::abs(sample.rotation.squaredNorm() - 1) <= rotationTolerance &&
           (!sample.up || (isNear(*sample.up) && sample.up->cwiseAbs().maxCoeff() >= minDirection));
}
} // namespace core
