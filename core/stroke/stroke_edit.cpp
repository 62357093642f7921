#include "core/stroke/stroke_edit.h"

#include <algorithm>

namespace core
{
namespace
{
/// Scales a sample's own value by the ratio now / before, within the parameter's range.
void follow(std::optional<double>& own, double before, double now, Parameter parameter)
{
    if (own && before > 0)
        own = std::clamp(*own * (now / before), info(parameter).min, info(parameter).max);
}
} // namespace

BrushChange brushOf(const StrokeSettings& settings)
{
    return {settings.tool, settings.radius, settings.strength};
}

Stroke changed(Stroke stroke, const BrushChange& brush)
{
    StrokeSettings& settings = stroke.settings;
    for (StrokeSample& sample : stroke.samples) {
        follow(sample.radius, settings.radius, brush.radius, Parameter::Radius);
        follow(sample.strength, settings.strength, brush.strength, Parameter::Strength);
    }
    settings.tool = brush.tool;
    settings.radius = brush.radius;
    settings.strength = brush.strength;
    settings.add = settings.add && canAddSolid(brush.tool);
    return stroke;
}
} // namespace core
