#pragma once

#include "vr/input/button_presets.h"
#include "vr/input/model_placement.h"
#include "vr/openxr/wand_state.h"

#include <variant>

namespace vr
{
/// Begins a stroke; only one is open at a time. Points belong to it until EndStroke.
struct BeginStroke
{
    bool smooths = false; ///< smooths, whatever tool is chosen
    /// Continues the last stroke, which ended only because the tool changed; the trigger was not pulled again.
    bool continues = false;
};

/// A point of the open stroke, in room space.
struct StrokePoint
{
    double time = 0; ///< seconds
    Pose tip;
    double pressure = 1; ///< above 0, at most 1
};

struct EndStroke
{};

struct Undo
{};
struct Redo
{};
struct SaveModel
{};
struct RestoreModel
{};

struct ToggleTopology
{};
struct ToggleBrushShape
{};
struct ToggleSymmetry
{};
struct ToggleInverse
{};

struct StepTool
{
    int by = 1;
};

// Radius of the brush in the room, metres. Trembling hands cannot use a smaller brush, and a larger one hides the
// model.
inline constexpr double minRadius = 0.002, maxRadius = 0.25, defaultRadius = 0.03;

struct ScaleRadius
{
    double factor = 1; ///< above 0
};

/// Selects the channel that ChangeChannel changes, which the panel highlights: 0 red, 1 green, 2 blue.
struct SelectChannel
{
    int channel = 0;
};

struct ChangeChannel
{
    int channel = 0;
    int by = 0; ///< added to the channel's value, which is 0 to 255; the sum may be outside that range
};

/// Turns the model about the document's Y axis.
struct TurnModel
{
    double angle = 0; ///< radians, anticlockwise seen from above
};

/// Scales the model about its middle.
struct ScaleModel
{
    double factor = 1; ///< above 0
};

/// Moves and turns the model with a hand, whose poses are in room space.
struct MoveModel
{
    Pose from, to;
};

/// Moves, turns and scales the model with both hands, as if it were tied to them.
struct StretchModel
{
    ModelPlacement::Span from, to;
};

struct OpenToolMenu
{
    bool isOpen = true;
};

struct OpenColorPanel
{
    bool isOpen = true;
};

/// Does the task of the sculpting hand (HandTask) at its tip, whose pose is in room space.
struct UseTip
{
    Pose tip;
};

/// Moves and turns the active part with the sculpting hand, whose poses are in room space. Followed by ReleasePart.
struct MovePart
{
    Pose from, to;
};

struct ReleasePart
{};

/// Presses a panel: the trigger was pulled while the wand pointed at it. The trigger belongs to the panel until
/// ReleasePanel.
struct PressPanel
{};

struct ReleasePanel
{
    bool isClick = true; ///< false: the press is cancelled, for example because the wand was lost
};

/// Reports that the hand's request is impossible now; the hand feels a vibration.
struct Refuse
{};

using WandAction =
    std::variant<BeginStroke, StrokePoint, EndStroke, Undo, Redo, SaveModel, RestoreModel, ToggleTopology,
                 ToggleBrushShape, ToggleSymmetry, ToggleInverse, StepTool, ScaleRadius, SelectChannel, ChangeChannel,
                 TurnModel, ScaleModel, MoveModel, StretchModel, OpenToolMenu, OpenColorPanel, UseTip, MovePart,
                 ReleasePart, PressPanel, ReleasePanel, Refuse>;

/// A request of a hand, and the gesture that made it. The gesture's label may fade once it was used.
struct WandCommand
{
    Side side = Side::Right; ///< the sculpting hand if both hands act together
    Gesture gesture = Gesture::Trigger;
    WandAction action;
};
} // namespace vr
