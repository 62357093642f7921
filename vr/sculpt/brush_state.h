#pragma once

#include "vr/input/wand_commands.h"
#include "vr/panels/panel_action.h"

#include "core/stroke/stroke.h"

namespace vr
{
// Of the brush, in the room; metres. A hand that trembles cannot use a smaller one, and a larger one hides the model.
inline constexpr double minRadius = 0.002, maxRadius = 0.25, defaultRadius = 0.03;
/// StrokeSettings::spacing of what wands draw, but for tools that follow the hand. A dab of full strength raises the
/// surface by a tenth of the radius: so far apart, it keeps up with the wand that pulls it.
inline constexpr double wandSpacing = 0.1;

/// The brush in the hand: what the next stroke will be.
struct BrushState
{
    core::StrokeSettings stroke; ///< what people choose of it; its radius, spacing, place and add are none of that
    bool addsNext = false;       ///< the next stroke adds a ball, or the stamp's model, and does nothing else
    bool isInverse = false;      ///< strokes do the opposite, where the tool has one
    ButtonPreset preset = ButtonPreset::Paper; ///< gives the order in which the pad steps through the tools
    std::optional<core::Symmetry> plane;       ///< of symmetry when it is on; nothing: none was chosen yet
    core::Topology topology =
        core::Topology::Adaptive; ///< of the headset when it is not uniform; at first the preset's
    core::AirbrushRates airbrush = core::defaultAirbrushRates();                ///< as the window has them
    double radius = defaultRadius;                                              ///< metres in the room
    double smoothStrength = core::info(core::Parameter::Strength).defaultValue; ///< while the other hand smooths
};

/// Returns the topology, other than uniform, with which a preset begins: the paper's adapts to the brush, the others'
/// keep detail.
core::Topology firstTopology(ButtonPreset preset);

/// Returns the plane of symmetry with which a preset begins: the paper's lies level, the others' parts left and right.
core::Symmetry firstPlane(ButtonPreset preset);

/// Returns the tools in the order in which a preset's pad steps through them: the palette's, except that with Paper the
/// five of the paper (section 4.1) come first.
std::vector<core::Tool> toolOrder(ButtonPreset preset);

/// Returns the brush after an action of a wand. The last tool is followed by the first; channels and the radius stop at
/// the ends of their ranges. An action that does not concern the brush changes nothing.
BrushState changed(BrushState brush, const WandAction& action);
/// Returns the brush after an action at a panel, likewise.
BrushState changed(BrushState brush, const PanelAction& action);

/// Of a stroke that begins now. Where a ball that pulls begins in empty space, it adds a ball to the model; a stroke
/// that only goes on adds none.
core::StrokeSettings strokeSettings(const BrushState& brush, const BeginStroke& begin, const ModelPlacement& placement);
/// In the document's space, where the model's orientation in the room is taken off already. It has its own radius: the
/// model may be scaled while it is sculpted; and alphas and stamps turn with the wand.
core::StrokeSample strokeSample(const BrushState& brush, const StrokePoint& point, const ModelPlacement& placement);
} // namespace vr
