#pragma once

#include <QString>

#include <optional>
#include <span>

namespace vr
{
/// A choice of functions for the buttons of the wands. Paper: section 4.1 of Zhu and Yang 2024, except that the side
/// button has to be held, the left trigger turns the model, too, and the other tools follow the five. Studio: usual in
/// other sculpting programs. OneHand: one wand has all functions, and no panel is attached to a hand; a second wand may
/// lie on a table.
enum class ButtonPreset { Paper, Studio, OneHand };

/// The role of a hand. In the paper the right hand sculpts.
enum class HandRole { Sculpting, Support };

/// The panel of a hand that is open. The support hand has the tool menu, the sculpting hand the colour panel. With
/// OneHand the sculpting hand has both; if both are open, the colour panel counts.
enum class HandMode {
    Any,   ///< in rows only: any of the following
    Plain, ///< no panel
    ToolMenu,
    ColorPanel
};
inline constexpr std::size_t handModeCount = 4;

/// A move of a finger on a wand. Trigger, the four of the pad and Squeeze, the side button, last as long as the press.
enum class Gesture {
    Trigger,
    PadLeft,
    PadRight,
    PadTop,
    PadBottom,
    Slide,       ///< a thumb moves on the pad without pressing it; right and up mean more
    SlideUpDown, ///< as Slide, except that moves across the pad are ignored
    Menu,
    MenuTap,  ///< released before holdSeconds
    MenuHold, ///< held for holdSeconds
    Squeeze,
    SqueezeHold
};

/// A function of a button or of the pad.
enum class WandFunction {
    Sculpt,
    Smooth,        ///< while it lasts, strokes of the other hand smooth
    TurnClockwise, ///< seen from above
    TurnAnticlockwise,
    MoveModel, ///< both hands together turn and scale it, too
    ScaleModel,
    SetRadius,
    Undo,
    Redo,
    SaveModel,
    RestoreModel,
    ToggleTopology,
    ToggleBrushShape,
    ToggleSymmetry,
    ToggleInverse, ///< for tools that have an inverse
    ToggleToolMenu,
    PreviousTool,
    NextTool,
    ToggleColorPanel,
    PreviousChannel,
    NextChannel,
    SetChannel
};

/// A function of a button. WandMapping executes these rows, and the labels at the buttons show them. A button without a
/// row does nothing.
struct PresetRow
{
    HandRole hand;
    HandMode mode;
    Gesture gesture;
    WandFunction function;
    const char* label; ///< a word or two, untranslated
};

/// Returns the rows of a preset.
std::span<const PresetRow> presetRows(ButtonPreset preset);

/// A gesture of a hand, and the panel that is open then.
struct WandControl
{
    HandRole hand;
    HandMode mode; ///< never Any
    Gesture gesture;
};
/// Returns the function of the gesture; nothing if it has none.
std::optional<WandFunction> functionOf(ButtonPreset preset, const WandControl& control);

/// Returns the label in the program's language. `isStick`: the wand has a thumbstick in place of the pad.
QString labelOf(const PresetRow& row, bool isStick);
} // namespace vr
