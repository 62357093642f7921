#pragma once

#include "vr/input/wand_commands.h"
#include "vr/panels/panel_action.h"

#include "core/stroke/stroke.h"

namespace vr
{
/// StrokeSettings::spacing of strokes by wands, radii; not used for tools that follow the hand. A dab of full strength
/// raises the surface by a tenth of the radius, so with this spacing the surface keeps up with the wand that pulls it.
inline constexpr double wandSpacing = 0.1;

/// The brush of the sculpting hand: the settings of the next stroke.
struct BrushState
{
    core::StrokeSettings stroke; ///< user's choices; radius, spacing, place, airbrush and add are not used
    bool addsNext = false;       ///< the next stroke only adds a ball, or the stamp's model
    bool isInverse = false;      ///< strokes use the opposite of the tool, if it has one
    ButtonPreset preset = ButtonPreset::Paper; ///< gives the order in which the pad steps through the tools
    std::optional<core::Symmetry> plane;       ///< plane used when symmetry is on; none: firstPlane() of the preset
    core::Topology topology = core::Topology::Adaptive; ///< topology used when it is not uniform
    /// Airbrush rates of the tools, as in the window.
    core::AirbrushRates airbrush = core::defaultAirbrushRates();
    double radius = defaultRadius; ///< radius in the room, metres
    /// Strength while the other hand makes strokes smooth.
    double smoothStrength = core::info(core::Parameter::Strength).defaultValue;
};

/// Returns the topology, other than uniform, with which a preset begins. That of Paper adapts to the brush, that of the
/// other presets keeps detail.
core::Topology firstTopology(ButtonPreset preset);

/// Returns the plane of symmetry with which a preset begins: Paper's is horizontal, that of the others separates left
/// and right.
core::Symmetry firstPlane(ButtonPreset preset);

/// Returns the tools in the order in which a preset's pad steps through them. It is the order of the palette, except
/// that with Paper the five tools of the paper (section 4.1) come first.
std::vector<core::Tool> toolOrder(ButtonPreset preset);

/// Returns the brush after an action of a wand. The last tool is followed by the first; channels and the radius stop at
/// the ends of their ranges. An action that does not concern the brush changes nothing.
BrushState changed(BrushState brush, const WandAction& action);
/// Returns the brush after an action at a panel. An action that does not concern the brush changes nothing.
BrushState changed(BrushState brush, const PanelAction& action);

/// Returns the settings of a stroke that begins now. A spherical brush of Pull or Stamp that begins in empty space adds
/// a ball or the stamp's model, unless the stroke only continues another.
core::StrokeSettings strokeSettings(const BrushState& brush, const BeginStroke& begin, const ModelPlacement& placement);
/// Returns a point of a stroke in document space, corrected for the model's placement in the room. Each point has its
/// own radius, because the model may be scaled during the stroke. Its up direction makes alphas and stamps turn with
/// the wand.
core::StrokeSample strokeSample(const BrushState& brush, const StrokePoint& point, const ModelPlacement& placement);
} // namespace vr
