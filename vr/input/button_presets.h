#pragma once

#include <QString>

#include <optional>
#include <span>

namespace vr
{
/// An assignment of functions to the buttons of the wands.
///
/// - Paper: section 4.1 of Zhu and Yang 2024, with three differences. The side button has to be held, the left trigger
///   also moves and turns the model, and there are more tools than the paper's five.
/// - Studio: the assignment that is usual in other sculpting programs.
/// - OneHand: one wand has all functions, and no panel is attached to a hand. A second wand is not needed.
enum class ButtonPreset { Paper, Studio, OneHand };

/// The role of a hand. In the paper the right hand sculpts.
enum class HandRole { Sculpting, Support };

/// The panel that is open at a hand. The support hand has the tool menu, the sculpting hand the colour panel. With
/// OneHand the sculpting hand has both panels; if both are open, the mode is ColorPanel.
enum class HandMode {
    Any,   ///< table rows with this mode apply to all modes; no hand has it
    Plain, ///< no panel
    ToolMenu,
    ColorPanel
};
inline constexpr std::size_t handModeCount = 4;

/// Tasks of the sculpting hand's trigger and side button. While a panel has another use for them than sculpting, the
/// rows of taskRows() replace those of any preset.
enum class HandTask {
    Sculpt,
    ChoosePart, ///< makes parts of the model active
    PlaceShape, ///< adds a shape
    DrawTube,   ///< draws the path of a tube, as a stroke
    Cut         ///< cuts with a blade
};

/// A movement of a finger on a wand. Trigger, the four Pad gestures and Squeeze (the side button) last as long as the
/// press.
enum class Gesture {
    Trigger,
    PadLeft,
    PadRight,
    PadTop,
    PadBottom,
    Slide,       ///< the thumb moves on the pad without pressing it; right and up increase a value
    SlideUpDown, ///< a Slide up or down; movements to the left and right are ignored
    Menu,
    MenuTap,  ///< menu button released before holdSeconds
    MenuHold, ///< menu button held for holdSeconds
    Squeeze,
    SqueezeHold
};

/// A function of a button or of the pad.
enum class WandFunction {
    Sculpt,
    Smooth,        ///< while the button is held, strokes of the other hand smooth
    TurnClockwise, ///< clockwise as seen from above
    TurnAnticlockwise,
    MoveModel, ///< moves the model with a hand; both hands also turn and scale it
    ScaleModel,
    SetRadius,
    Undo,
    Redo,
    SaveModel,
    RestoreModel,
    ToggleTopology,
    ToggleBrushShape,
    ToggleSymmetry,
    ToggleInverse, ///< swaps a tool for its inverse, such as Pull for Push
    ToggleToolMenu,
    PreviousTool,
    NextTool,
    ToggleColorPanel,
    PreviousChannel,
    NextChannel,
    SetChannel,
    UseTip,  ///< does the hand's task at the wand's tip
    MovePart ///< moves the active part with the hand
};

/// A function of a gesture. WandMapping executes these rows, and the labels at the buttons show them. A gesture without
/// a row does nothing.
struct PresetRow
{
    HandRole hand;
    HandMode mode;
    Gesture gesture;
    WandFunction function;
    const char* label; ///< up to three words, untranslated
};

/// Returns the rows of a preset.
std::span<const PresetRow> presetRows(ButtonPreset preset);
/// Returns the rows for bare hands, which have only the gestures Trigger (a pinch), Squeeze (a fist) and Menu (a palm
/// turned to the face). They are the same for Paper and Studio.
std::span<const PresetRow> handRows(ButtonPreset preset);
inline constexpr std::size_t maxHandRows = 8;
/// Returns the rows of a task, at most maxTaskRows. Each replaces all rows of the preset for the same hand and button.
std::span<const PresetRow> taskRows(HandTask task);
inline constexpr std::size_t maxTaskRows = 4;
/// Returns whether a row of the task replaces this row of a preset.
bool isReplaced(const PresetRow& row, HandTask task);

/// A gesture of a hand, and the hand's mode at that moment.
struct WandControl
{
    HandRole hand;
    HandMode mode; ///< mode of the hand; never Any
    Gesture gesture;
    HandTask task = HandTask::Sculpt; ///< task of the sculpting hand
    bool isBare = false;              ///< the hand holds no wand
};
/// Returns the function of the gesture; none if it has no function.
std::optional<WandFunction> functionOf(ButtonPreset preset, const WandControl& control);

/// Returns the label in the user's language. `isStick`: the wand has a thumbstick in place of the pad.
QString labelOf(const PresetRow& row, bool isStick);
} // namespace vr
