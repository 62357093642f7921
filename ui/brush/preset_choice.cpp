#include "ui/brush/preset_choice.h"

#include "ui/brush/brush_shapes.h"

#include <algorithm>
#include <tuple>

namespace ui
{
namespace
{
auto valuesOf(const core::StrokeSettings& stroke)
{
    return std::tuple(stroke.tool, stroke.strength, stroke.falloff, stroke.spacing, stroke.alphaFollows,
                      stroke.anchored);
}
} // namespace

core::BrushPreset presetOf(const BrushSettings& brush)
{
    core::BrushPreset preset;
    preset.stroke = brush.stroke();
    preset.stroke.airbrush = brush.tools()->airbrush(brush.tool());
    preset.stroke.inverted = brush.isInverted();
    preset.chosen.reach = preset.chosen.detail = true;
    preset.chosen.color = brush.tool() == core::Tool::Paint;
    preset.radiusShare = std::clamp(brush.radiusShare(), core::minPresetRadius, core::maxPresetRadius);
    return preset;
}

QString takePreset(const PresetFile& file, BrushSettings* brush, BrushShapes* shapes)
{
    using core::StrokeSettings;
    const core::BrushPreset& preset = *file.preset;
    const StrokeSettings& stroke = preset.stroke;
    const QString problem = preset.alpha.file.empty() ? QString() : layAlphaDown(file);
    brush->setTool(stroke.tool);
    ToolValues values = brush->tools()->of(stroke.tool);
    values.strength = stroke.strength;
    values.falloff = stroke.falloff;
    values.spacing = stroke.spacing;
    values.alphaFollows = stroke.alphaFollows;
    values.anchored = stroke.anchored;
    values.airbrush = core::canAirbrush(stroke.tool) ? stroke.airbrush : values.airbrush;
    if (preset.radiusShare && !brush->tools()->sharesRadius())
        values.radiusShare = preset.radiusShare;
    brush->tools()->set(stroke.tool, values);
    if (preset.chosen.reach)
        brush->set(&StrokeSettings::brush, stroke.brush);
    if (preset.chosen.topology)
        brush->set(&StrokeSettings::topology, stroke.topology);
    if (preset.chosen.detail)
        brush->setValue(core::Parameter::Detail, stroke.detail);
    if (preset.chosen.color)
        brush->set(&StrokeSettings::color, stroke.color);
    brush->setInverted(stroke.inverted);
    if (stroke.alpha)
        shapes->chooseAlpha(QString::fromStdString(stroke.alpha->source()), AlphaSpacing::Kept);
    else
        shapes->chooseAlpha(preset.alpha.file.empty() || !problem.isEmpty() ? QString() : alphaPath(file),
                            AlphaSpacing::Kept);
    return problem;
}

bool isInHand(const core::BrushPreset& preset, const BrushSettings& brush)
{
    return valuesOf(preset.stroke) == valuesOf(brush.stroke()) && preset.stroke.inverted == brush.isInverted();
}
} // namespace ui
