#pragma once

#include "vr/input/button_presets.h"
#include "vr/input/model_placement.h"
#include "vr/openxr/wand_state.h"

#include <variant>

namespace vr
{
/// One is open at a time: what follows up to EndStroke is its.
struct BeginStroke
{
    bool smooths = false;   ///< whatever the tool is
    bool continues = false; ///< the trigger was not pulled again: the stroke before it ended because the tool changed
};

/// Room space.
struct StrokePoint
{
    double time = 0; ///< seconds
    Pose tip;
    double pressure = 1; ///< above 0, to 1
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

struct ScaleRadius
{
    double factor = 1; ///< above 0
};

/// The channel that ChangeChannel changes, for the panel to show: 0 red, 1 green, 2 blue.
struct SelectChannel
{
    int channel = 0;
};

struct ChangeChannel
{
    int channel = 0;
    int by = 0; ///< of 255; the sum may ask for more than a channel takes
};

/// Turns the model about the document's Y axis.
struct TurnModel
{
    double angle = 0; ///< radians, anticlockwise seen from above
};

/// About the model's centre.
struct ScaleModel
{
    double factor = 1; ///< above 0
};

/// The model goes with a hand. Room space.
struct MoveModel
{
    Pose from, to;
};

/// The model goes with both hands, as if it were tied to them.
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

/// The trigger was pulled while the wand pointed at a panel. The panel has it until ReleasePanel.
struct PressPanel
{};

struct ReleasePanel
{
    bool isClick = true; ///< false: the wand was lost
};

/// What the hand asks for cannot be now: it shall feel that.
struct Refuse
{};

using WandAction = std::variant<BeginStroke, StrokePoint, EndStroke, Undo, Redo, SaveModel, RestoreModel,
                                ToggleTopology, ToggleBrushShape, ToggleSymmetry, ToggleInverse, StepTool, ScaleRadius,
                                SelectChannel, ChangeChannel, TurnModel, ScaleModel, MoveModel, StretchModel,
                                OpenToolMenu, OpenColorPanel, PressPanel, ReleasePanel, Refuse>;

/// What a hand wants done, and by which gesture: its label may fade.
struct WandCommand
{
    Side side = Side::Right; ///< of what two hands do together, the sculpting one
    Gesture gesture = Gesture::Trigger;
    WandAction action;
};
} // namespace vr
