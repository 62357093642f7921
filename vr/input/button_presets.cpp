#include "vr/input/button_presets.h"

#include <QCoreApplication>

#include <cassert>

namespace vr
{
namespace
{
/// Tables of the presets. They are in a class because using enum at namespace scope reaches the next files of a unity
/// build.
struct Rows
{
    using enum HandRole;
    using enum HandMode;
    using enum Gesture;
    using F = WandFunction;

    // clang-format off
    static constexpr PresetRow paper[] = {
        {Support, Plain,    PadLeft,   F::TurnClockwise,     QT_TRANSLATE_NOOP("vr::Presets", "Turn clockwise")},
        {Support, Plain,    PadRight,  F::TurnAnticlockwise, QT_TRANSLATE_NOOP("vr::Presets", "Turn anticlockwise")},
        {Support, Plain,    PadTop,    F::ToggleTopology,    QT_TRANSLATE_NOOP("vr::Presets", "Uniform or not")},
        {Support, Plain,    PadBottom, F::ToggleTopology,    QT_TRANSLATE_NOOP("vr::Presets", "Uniform or not")},
        {Support, Any,      Slide,     F::ScaleModel,        QT_TRANSLATE_NOOP("vr::Presets", "Slide: scale")},
        {Support, Any,      Menu,      F::ToggleToolMenu,    QT_TRANSLATE_NOOP("vr::Presets", "Tools")},
        {Support, ToolMenu, PadLeft,   F::PreviousTool,      QT_TRANSLATE_NOOP("vr::Presets", "Previous tool")},
        {Support, ToolMenu, PadRight,  F::NextTool,          QT_TRANSLATE_NOOP("vr::Presets", "Next tool")},
        {Support, Any,      Trigger,   F::MoveModel,         QT_TRANSLATE_NOOP("vr::Presets", "Move model")},
        {Support, Any,      SqueezeHold, F::SaveModel,         QT_TRANSLATE_NOOP("vr::Presets", "Hold: save")},

        {Sculpting, Plain,      PadTop,      F::ToggleBrushShape, QT_TRANSLATE_NOOP("vr::Presets", "Sphere or ray")},
        {Sculpting, Plain,      PadBottom,   F::ToggleSymmetry,   QT_TRANSLATE_NOOP("vr::Presets", "Symmetry")},
        {Sculpting, Plain,      PadLeft,     F::Undo,             QT_TRANSLATE_NOOP("vr::Presets", "Undo")},
        {Sculpting, Plain,      PadRight,    F::Redo,             QT_TRANSLATE_NOOP("vr::Presets", "Redo")},
        {Sculpting, Plain,      Slide,       F::SetRadius,        QT_TRANSLATE_NOOP("vr::Presets", "Slide: radius")},
        {Sculpting, Any,        Menu,        F::ToggleColorPanel, QT_TRANSLATE_NOOP("vr::Presets", "Colour")},
        {Sculpting, ColorPanel, PadLeft,     F::PreviousChannel,  QT_TRANSLATE_NOOP("vr::Presets", "Previous channel")},
        {Sculpting, ColorPanel, PadRight,    F::NextChannel,      QT_TRANSLATE_NOOP("vr::Presets", "Next channel")},
        {Sculpting, ColorPanel, SlideUpDown, F::SetChannel,       QT_TRANSLATE_NOOP("vr::Presets", "Slide: value")},
        {Sculpting, Any,        Trigger,     F::Sculpt,           QT_TRANSLATE_NOOP("vr::Presets", "Sculpt")},
        {Sculpting, Any,        SqueezeHold, F::RestoreModel,     QT_TRANSLATE_NOOP("vr::Presets", "Hold: restore")},
    };

    /// Functions of the Studio preset. Saving and restoring have no buttons here; they are on panels.
    static constexpr PresetRow studio[] = {
        {Support, Any, PadLeft,   F::Undo,           QT_TRANSLATE_NOOP("vr::Presets", "Undo")},
        {Support, Any, PadRight,  F::Redo,           QT_TRANSLATE_NOOP("vr::Presets", "Redo")},
        {Support, Any, PadTop,    F::ToggleTopology, QT_TRANSLATE_NOOP("vr::Presets", "Uniform or not")},
        {Support, Any, PadBottom, F::ToggleTopology, QT_TRANSLATE_NOOP("vr::Presets", "Uniform or not")},
        {Support, Any, Menu,      F::ToggleToolMenu, QT_TRANSLATE_NOOP("vr::Presets", "Tools")},
        {Support, Any, Trigger,   F::Smooth,         QT_TRANSLATE_NOOP("vr::Presets", "Smooth")},
        {Support, Any, Squeeze,   F::MoveModel,      QT_TRANSLATE_NOOP("vr::Presets", "Move model")},

        {Sculpting, Plain,      PadTop,      F::ToggleBrushShape, QT_TRANSLATE_NOOP("vr::Presets", "Sphere or ray")},
        {Sculpting, Plain,      PadBottom,   F::ToggleSymmetry,   QT_TRANSLATE_NOOP("vr::Presets", "Symmetry")},
        {Sculpting, Plain,      PadLeft,     F::PreviousTool,     QT_TRANSLATE_NOOP("vr::Presets", "Previous tool")},
        {Sculpting, Plain,      PadRight,    F::NextTool,         QT_TRANSLATE_NOOP("vr::Presets", "Next tool")},
        {Sculpting, Plain,      SlideUpDown, F::SetRadius,        QT_TRANSLATE_NOOP("vr::Presets", "Slide: radius")},
        {Sculpting, Any,        MenuTap,     F::ToggleColorPanel, QT_TRANSLATE_NOOP("vr::Presets", "Colour")},
        {Sculpting, Any,        MenuHold,    F::ToggleInverse,    QT_TRANSLATE_NOOP("vr::Presets", "Hold: invert")},
        {Sculpting, ColorPanel, PadLeft,     F::PreviousChannel,  QT_TRANSLATE_NOOP("vr::Presets", "Previous channel")},
        {Sculpting, ColorPanel, PadRight,    F::NextChannel,      QT_TRANSLATE_NOOP("vr::Presets", "Next channel")},
        {Sculpting, ColorPanel, SlideUpDown, F::SetChannel,       QT_TRANSLATE_NOOP("vr::Presets", "Slide: value")},
        {Sculpting, Any,        Trigger,     F::Sculpt,           QT_TRANSLATE_NOOP("vr::Presets", "Sculpt")},
        {Sculpting, Any,        Squeeze,     F::MoveModel,        QT_TRANSLATE_NOOP("vr::Presets", "Move model")},
    };
    /// Functions of the OneHand preset. All others, such as saving and restoring, are on panels.
    static constexpr PresetRow oneHand[] = {
        {Sculpting, Plain,      PadLeft,     F::Undo,             QT_TRANSLATE_NOOP("vr::Presets", "Undo")},
        {Sculpting, ToolMenu,   PadLeft,     F::PreviousTool,     QT_TRANSLATE_NOOP("vr::Presets", "Previous tool")},
        {Sculpting, Plain,      PadRight,    F::Redo,             QT_TRANSLATE_NOOP("vr::Presets", "Redo")},
        {Sculpting, ToolMenu,   PadRight,    F::NextTool,         QT_TRANSLATE_NOOP("vr::Presets", "Next tool")},
        {Sculpting, Plain,      PadTop,      F::ToggleInverse,    QT_TRANSLATE_NOOP("vr::Presets", "Invert")},
        {Sculpting, Plain,      PadBottom,   F::ToggleSymmetry,   QT_TRANSLATE_NOOP("vr::Presets", "Symmetry")},
        {Sculpting, Plain,      SlideUpDown, F::SetRadius,        QT_TRANSLATE_NOOP("vr::Presets", "Slide: radius")},
        {Sculpting, ToolMenu,   SlideUpDown, F::ScaleModel,       QT_TRANSLATE_NOOP("vr::Presets", "Slide: scale")},
        {Sculpting, Any,        MenuTap,     F::ToggleToolMenu,   QT_TRANSLATE_NOOP("vr::Presets", "Tools")},
        {Sculpting, Any,        MenuHold,    F::ToggleColorPanel, QT_TRANSLATE_NOOP("vr::Presets", "Hold: colour")},
        {Sculpting, ColorPanel, PadLeft,     F::PreviousChannel,  QT_TRANSLATE_NOOP("vr::Presets", "Previous channel")},
        {Sculpting, ColorPanel, PadRight,    F::NextChannel,      QT_TRANSLATE_NOOP("vr::Presets", "Next channel")},
        {Sculpting, ColorPanel, SlideUpDown, F::SetChannel,       QT_TRANSLATE_NOOP("vr::Presets", "Slide: value")},
        {Sculpting, Any,        Trigger,     F::Sculpt,           QT_TRANSLATE_NOOP("vr::Presets", "Sculpt")},
        {Sculpting, Any,        Squeeze,     F::MoveModel,        QT_TRANSLATE_NOOP("vr::Presets", "Move model")},
    };
    /// Functions of two bare hands. All others, such as undo, are on panels.
    static constexpr PresetRow bareHands[] = {
        {Support,   Any, Trigger, F::Smooth,           QT_TRANSLATE_NOOP("vr::Presets", "Pinch: smooth")},
        {Support,   Any, Squeeze, F::MoveModel,        QT_TRANSLATE_NOOP("vr::Presets", "Fist: move model")},
        {Support,   Any, Menu,    F::ToggleToolMenu,   QT_TRANSLATE_NOOP("vr::Presets", "Palm: tools")},
        {Sculpting, Any, Trigger, F::Sculpt,           QT_TRANSLATE_NOOP("vr::Presets", "Pinch: sculpt")},
        {Sculpting, Any, Squeeze, F::MoveModel,        QT_TRANSLATE_NOOP("vr::Presets", "Fist: move model")},
        {Sculpting, Any, Menu,    F::ToggleColorPanel, QT_TRANSLATE_NOOP("vr::Presets", "Palm: colour")},
    };
    static constexpr PresetRow oneBareHand[] = {
        {Sculpting, Any, Trigger, F::Sculpt,         QT_TRANSLATE_NOOP("vr::Presets", "Pinch: sculpt")},
        {Sculpting, Any, Squeeze, F::MoveModel,      QT_TRANSLATE_NOOP("vr::Presets", "Fist: move model")},
        {Sculpting, Any, Menu,    F::ToggleToolMenu, QT_TRANSLATE_NOOP("vr::Presets", "Palm: tools")},
    };
    static constexpr PresetRow choosePart[] = {
        {Sculpting, Any, Trigger, F::UseTip,   QT_TRANSLATE_NOOP("vr::Presets", "Choose part")},
        {Sculpting, Any, Squeeze, F::MovePart, QT_TRANSLATE_NOOP("vr::Presets", "Move part")},
    };
    static constexpr PresetRow placeShape[] = {
        {Sculpting, Any, Trigger, F::UseTip,   QT_TRANSLATE_NOOP("vr::Presets", "Place shape")},
        {Sculpting, Any, Squeeze, F::MovePart, QT_TRANSLATE_NOOP("vr::Presets", "Move part")},
    };
    static constexpr PresetRow drawTube[] = {
        {Sculpting, Any, Trigger, F::Sculpt,   QT_TRANSLATE_NOOP("vr::Presets", "Draw tube")},
        {Sculpting, Any, Squeeze, F::MovePart, QT_TRANSLATE_NOOP("vr::Presets", "Move part")},
    };
    static constexpr PresetRow cut[] = {
        {Sculpting, Any, Trigger, F::UseTip,   QT_TRANSLATE_NOOP("vr::Presets", "Cut")},
        {Sculpting, Any, Squeeze, F::MovePart, QT_TRANSLATE_NOOP("vr::Presets", "Move part")},
    };
    // clang-format on
};

constexpr bool answers(const PresetRow& row, const WandControl& control)
{
    return row.hand == control.hand && row.gesture == control.gesture &&
           (row.mode == HandMode::Any || row.mode == control.mode);
}

/// Returns whether one movement of a finger can be both gestures.
constexpr bool overlap(Gesture a, Gesture b)
{
    using enum Gesture;
    const auto are = [&](Gesture first, Gesture second) {
        return (a == first && b == second) || (a == second && b == first);
    };
    return a == b || are(Slide, SlideUpDown) || are(Menu, MenuTap) || are(Menu, MenuHold) || are(Squeeze, SqueezeHold);
}

/// Returns whether no movement of a finger has two functions.
constexpr bool isClear(std::span<const PresetRow> table)
{
    for (std::size_t i = 0; i < table.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
            const bool sameMode =
                table[i].mode == table[j].mode || table[i].mode == HandMode::Any || table[j].mode == HandMode::Any;
            if (table[i].hand == table[j].hand && sameMode && overlap(table[i].gesture, table[j].gesture))
                return false;
        }
    return true;
}
static_assert(isClear(Rows::paper) && isClear(Rows::studio) && isClear(Rows::oneHand));
static_assert(isClear(Rows::bareHands) && isClear(Rows::oneBareHand));
static_assert(isClear(Rows::choosePart) && isClear(Rows::placeShape) && isClear(Rows::drawTube) && isClear(Rows::cut));

/// Returns the label for a thumbstick, which slides only while it is pressed in.
const char* stickLabel(const PresetRow& row)
{
    switch (row.function) {
    case WandFunction::ScaleModel:
        return QT_TRANSLATE_NOOP("vr::Presets", "Press, push: scale");
    case WandFunction::SetRadius:
        return QT_TRANSLATE_NOOP("vr::Presets", "Press, push: radius");
    case WandFunction::SetChannel:
        return QT_TRANSLATE_NOOP("vr::Presets", "Press, push: value");
    default:
        return row.label;
    }
}
} // namespace

std::span<const PresetRow> presetRows(ButtonPreset preset)
{
    switch (preset) {
    case ButtonPreset::Paper:
        return Rows::paper;
    case ButtonPreset::Studio:
        return Rows::studio;
    case ButtonPreset::OneHand:
        return Rows::oneHand;
    }
    return {};
}

std::span<const PresetRow> handRows(ButtonPreset preset)
{
    if (preset == ButtonPreset::OneHand)
        return Rows::oneBareHand;
    return Rows::bareHands;
}

std::span<const PresetRow> taskRows(HandTask task)
{
    switch (task) {
    case HandTask::Sculpt:
        return {};
    case HandTask::ChoosePart:
        return Rows::choosePart;
    case HandTask::PlaceShape:
        return Rows::placeShape;
    case HandTask::DrawTube:
        return Rows::drawTube;
    case HandTask::Cut:
        return Rows::cut;
    }
    return {};
}

bool isReplaced(const PresetRow& row, HandTask task)
{
    for (const PresetRow& other : taskRows(task))
        if (other.hand == row.hand && overlap(other.gesture, row.gesture))
            return true;
    return false;
}

std::optional<WandFunction> functionOf(ButtonPreset preset, const WandControl& control)
{
    assert(control.mode != HandMode::Any);
    for (const PresetRow& row : taskRows(control.task))
        if (answers(row, control))
            return row.function;
    for (const PresetRow& row : control.isBare ? handRows(preset) : presetRows(preset))
        if (answers(row, control) && !isReplaced(row, control.task))
            return row.function;
    return std::nullopt;
}

QString labelOf(const PresetRow& row, bool isStick)
{
    return QCoreApplication::translate("vr::Presets", isStick ? stickLabel(row) : row.label);
}
} // namespace vr
