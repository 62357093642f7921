#pragma once

#include <QString>

#include <optional>
#include <span>

namespace vr
{
/// Paper: as in section 4.1 of Zhu & Yang 2024, but that save and restore are held. Studio: as other programs of the
/// field have it. OneHand: the sculpting hand does all, and no panel goes with a hand; a second wand may lie on a
/// table.
enum class ButtonPreset { Paper, Studio, OneHand };

/// In the paper the right hand sculpts.
enum class HandRole { Sculpting, Support };

/// Whether a hand's panel is open: the support hand has the tool menu, the sculpting hand the colour panel. One hand
/// has both: the colours count before the tools.
enum class HandMode {
    Any,   ///< in rows: open or not
    Plain, ///< closed
    ToolMenu,
    ColorPanel
};

/// Those that last, last as long as what they press: the trigger, the pad, and Squeeze, which is the side button.
enum class Gesture {
    Trigger,
    PadLeft,
    PadRight,
    PadTop,
    PadBottom,
    Slide,       ///< a thumb that moves on the pad without pressing; right and up are more
    SlideUpDown, ///< the same, but one that moves across is none
    Menu,
    MenuTap,  ///< let go before it was held
    MenuHold, ///< held for holdSeconds
    Squeeze,
    SqueezeHold
};

/// What a hand can do by its wand.
enum class WandFunction {
    Sculpt,
    Smooth,        ///< while it lasts, what the other hand draws smooths
    TurnClockwise, ///< seen from above
    TurnAnticlockwise,
    MoveModel, ///< with both hands it is turned and scaled, too
    ScaleModel,
    SetRadius,
    Undo,
    Redo,
    SaveModel,
    RestoreModel,
    ToggleTopology,
    ToggleBrushShape,
    ToggleSymmetry,
    ToggleInverse, ///< of tools that have an opposite
    ToggleToolMenu,
    PreviousTool,
    NextTool,
    ToggleColorPanel,
    PreviousChannel,
    NextChannel,
    SetChannel
};

/// One row a function of a button. WandMapping follows these rows, and labels at the buttons are written from them. A
/// button of no row does nothing.
struct PresetRow
{
    HandRole hand;
    HandMode mode;
    Gesture gesture;
    WandFunction function;
    const char* label; ///< a word or two, untranslated
};

std::span<const PresetRow> presetRows(ButtonPreset preset);

struct WandControl
{
    HandRole hand;
    HandMode mode; ///< the hand's own, never Any
    Gesture gesture;
};
/// Nothing if it does nothing.
std::optional<WandFunction> functionOf(ButtonPreset preset, const WandControl& control);

/// In the program's language.
QString labelOf(const PresetRow& row);
} // namespace vr
