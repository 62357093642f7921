#include "vr/sculpt/brush_state.h"

#include "core/util/overloaded.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace vr
{
namespace
{
constexpr std::array channels{&core::Rgb::r, &core::Rgb::g, &core::Rgb::b};

bool isOfPaper(core::Tool tool)
{
    using enum core::Tool;
    return tool == Pull || tool == Push || tool == Flatten || tool == Smooth || tool == Paint;
}

core::Tool stepped(const BrushState& brush, int by)
{
    const std::vector<core::Tool> order = toolOrder(brush.preset);
    const int count = static_cast<int>(order.size());
    const auto at = static_cast<int>(std::ranges::find(order, brush.stroke.tool) - order.begin());
    return order[static_cast<std::size_t>(((at + by) % count + count) % count)];
}

core::Rgb changedColor(core::Rgb color, const ChangeChannel& change)
{
    std::uint8_t& value = color.*channels[static_cast<std::size_t>(change.channel)];
    value = static_cast<std::uint8_t>(std::clamp(value + change.by, 0, 255));
    return color;
}

core::Rgb changedColor(core::Rgb color, const Slide& slide)
{
    if (const auto channel = static_cast<std::size_t>(slide.slider); channel < channels.size())
        color.*channels[channel] = static_cast<std::uint8_t>(slide.value);
    return color;
}

bool isAdding(const BrushState& brush, const BeginStroke& begin)
{
    return brush.addsNext && !begin.smooths && !begin.continues;
}

/// Returns the settings of a stroke with this brush, changed by the other hand's smoothing, by adding or by inversion.
core::StrokeSettings effective(const BrushState& brush, const BeginStroke& begin)
{
    core::StrokeSettings settings = brush.stroke;
    if (begin.smooths) {
        settings.tool = core::Tool::Smooth;
        settings.strength = brush.smoothStrength;
        settings.alpha = nullptr; // smoothing is even over the brush
        settings.anchored = false;
    } else if (isAdding(brush, begin)) {
        return core::addingSolid(settings);
    }
    return brush.isInverse ? core::opposite(settings) : settings;
}

double radiusOn(const BrushState& brush, const ModelPlacement& placement)
{
    const core::ParameterInfo& range = core::info(core::Parameter::Radius);
    return std::clamp(placement.lengthToModel(brush.radius), range.min, range.max);
}

void setSymmetric(BrushState& brush, bool isSymmetric)
{
    const core::Symmetry plane = brush.plane.value_or(firstPlane(brush.preset));
    brush.stroke.symmetry = isSymmetric ? plane : core::Symmetry::None;
}

void chooseTopology(BrushState& brush, core::Topology topology)
{
    brush.stroke.topology = topology;
    if (topology != core::Topology::Uniform)
        brush.topology = topology;
}
} // namespace

core::Topology firstTopology(ButtonPreset preset)
{
    return preset == ButtonPreset::Paper ? core::Topology::Adaptive : core::Topology::Refine;
}

core::Symmetry firstPlane(ButtonPreset preset)
{
    return preset == ButtonPreset::Paper ? core::Symmetry::Y : core::Symmetry::X;
}

std::vector<core::Tool> toolOrder(ButtonPreset preset)
{
    std::vector<core::Tool> tools;
    for (std::size_t i = 0; i < core::toolNames().size(); ++i)
        tools.push_back(static_cast<core::Tool>(i));
    if (preset == ButtonPreset::Paper)
        std::ranges::stable_partition(tools, isOfPaper);
    return tools;
}

BrushState changed(BrushState brush, const WandAction& action)
{
    using core::BrushShape, core::Symmetry, core::Topology;
    core::StrokeSettings& stroke = brush.stroke;
    const core::Overloaded change{
        [&](const StepTool& step) {
            stroke.tool = stepped(brush, step.by);
            brush.addsNext = false;
        },
        [&](ToggleInverse) { brush.isInverse = !brush.isInverse; },
        [&](ToggleBrushShape) {
            stroke.brush = stroke.brush == BrushShape::Sphere ? BrushShape::Ray : BrushShape::Sphere;
        },
        [&](ToggleTopology) {
            stroke.topology = stroke.topology == Topology::Uniform ? brush.topology : Topology::Uniform;
        },
        [&](ToggleSymmetry) { setSymmetric(brush, stroke.symmetry == Symmetry::None); },
        [&](const ScaleRadius& scale) { brush.radius = std::clamp(brush.radius * scale.factor, minRadius, maxRadius); },
        [&](const ChangeChannel& step) { stroke.color = changedColor(stroke.color, step); },
        [](const auto&) {},
    };
    std::visit(change, action);
    return brush;
}

BrushState changed(BrushState brush, const PanelAction& action)
{
    core::StrokeSettings& stroke = brush.stroke;
    const core::Overloaded change{
        [&](core::Tool tool) {
            stroke.tool = tool;
            brush.addsNext = false;
        },
        [&](const AddNext& add) { brush.addsNext = add.isOn; },
        [&](core::BrushShape shape) { stroke.brush = shape; },
        [&](core::Topology topology) { chooseTopology(brush, topology); },
        [&](ButtonPreset preset) {
            brush.preset = preset;
            brush.topology = firstTopology(preset);
            if (stroke.topology != core::Topology::Uniform)
                stroke.topology = brush.topology;
        },
        [&](const ChooseSymmetry& symmetry) { setSymmetric(brush, symmetry.isOn); },
        [&](const ChooseRadial& chosen) { stroke.radial = chosen.count; },
        [&](const ChooseColor& chosen) { stroke.color = chosen.color; },
        [&](const Slide& slide) {
            stroke.color = changedColor(stroke.color, slide);
            if (slide.slider == PanelSlider::Radius)
                brush.radius = std::clamp(minRadius * std::exp2(slide.value), minRadius, maxRadius);
        },
        [](const auto&) {},
    };
    std::visit(change, action);
    return brush;
}

core::StrokeSettings strokeSettings(const BrushState& brush, const BeginStroke& begin, const ModelPlacement& placement)
{
    core::StrokeSettings settings = effective(brush, begin);
    settings.place = core::Placement::Point;
    settings.radius = radiusOn(brush, placement);
    settings.spacing = core::isDragTool(settings.tool) ? 0 : wandSpacing;
    settings.airbrush = brush.airbrush[static_cast<std::size_t>(settings.tool)];
    settings.add = core::canAddSolid(settings.tool) && settings.brush == core::BrushShape::Sphere && !begin.continues;
    return settings;
}

core::StrokeSample strokeSample(const BrushState& brush, const StrokePoint& point, const ModelPlacement& placement)
{
    core::StrokeSample sample;
    sample.time = point.time;
    sample.position = placement.toModel(point.tip.position);
    sample.direction = placement.directionToModel(point.tip.forward());
    sample.pressure = point.pressure;
    sample.radius = radiusOn(brush, placement);
    sample.up = placement.directionToModel(point.tip.rotation * core::Vec3::UnitY());
    return sample;
}
} // namespace vr
