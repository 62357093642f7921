#pragma once

#include "vr/input/button_presets.h"
#include "vr/openxr/wand_state.h"

#include "core/stroke/tool.h"

#include <QString>

#include <variant>

namespace vr
{
enum class PanelKind { Tools, Color, Files, Settings, Performance, Notice, Lesson };
inline constexpr std::size_t panelKindCount = 7;

enum class SettingsPage { General, Haptics };

/// Commands without parameters.
enum class PanelCommand {
    Undo,
    Redo,
    RestoreModel, ///< as it was when it was opened
    InvertMask,
    ClearMask,
    SaveModel, ///< under a new number
    Recentre,
    LevelModel, ///< its Y axis becomes vertical
    LeaveVr
};

struct ShowPanel
{
    PanelKind kind = PanelKind::Files;
    bool isShown = true;
    bool operator==(const ShowPanel&) const = default;
};

struct ChooseSymmetry
{
    bool isOn = true;
    bool operator==(const ChooseSymmetry&) const = default;
};

/// The next stroke adds a ball, or the stamp's model.
struct AddNext
{
    bool isOn = true;
    bool operator==(const AddNext&) const = default;
};

struct ChooseRadial
{
    int count = 1; ///< of sectors; 1: none
    bool operator==(const ChooseRadial&) const = default;
};

struct ChooseChannel
{
    int channel = 0; ///< 0 red, 1 green, 2 blue
    bool operator==(const ChooseChannel&) const = default;
};

struct ChooseColor
{
    core::Rgb color;
    bool operator==(const ChooseColor&) const = default;
};

struct ShowPage
{
    int page = 0; ///< of the files
    bool operator==(const ShowPage&) const = default;
};

/// Of a step's text.
struct ShowLessonPage
{
    int page = 0;
    bool operator==(const ShowLessonPage&) const = default;
};

/// What a pupil can request of a lesson.
enum class LessonRequest {
    Play,  ///< or pause
    TryIt, ///< what was done in the step is taken back
    Back,
    Next
};

/// To be opened, perhaps.
struct ChooseFile
{
    QString path;
    bool operator==(const ChooseFile&) const = default;
};

struct OpenFile
{
    QString path;
    bool discardsChanges = false; ///< the item said so, and must be held
    bool operator==(const OpenFile&) const = default;
};

/// The hand that sculpts.
struct ChooseHand
{
    Side sculpting = Side::Right;
    bool operator==(const ChooseHand&) const = default;
};

struct ShowPerformance
{
    bool isShown = true;
    bool operator==(const ShowPerformance&) const = default;
};

/// The grid on the ground.
struct ShowFloor
{
    bool isShown = true;
    bool operator==(const ShowFloor&) const = default;
};

enum class PanelSlider {
    Red, ///< 0 to 255, whole, as the next two; in the order of channels
    Green,
    Blue,
    Height,    ///< metres that the model stands higher
    TurnSpeed, ///< degrees a second
    Contact,   ///< 0 to 1, as the others; in the order of Sensation
    Texture,
    Fusion,
    Refusal,
    MenuStep,
    Hold
};

struct Slide
{
    PanelSlider slider = PanelSlider::Red;
    double value = 0; ///< in the slider's unit and range
    bool operator==(const Slide&) const = default;
};

/// What a person wants by an item of a panel.
using PanelAction =
    std::variant<PanelCommand, core::Tool, core::BrushShape, core::Topology, ButtonPreset, SettingsPage, ShowPanel,
                 AddNext, ChooseSymmetry, ChooseRadial, ChooseChannel, ChooseColor, ShowPage, ChooseFile, OpenFile,
                 ChooseHand, ShowPerformance, ShowFloor, Slide, ShowLessonPage, LessonRequest>;

/// Returns whether both are of one item: a slider asks for one value after the other.
inline bool isSameItem(const PanelAction& a, const PanelAction& b)
{
    const auto *slideA = std::get_if<Slide>(&a), *slideB = std::get_if<Slide>(&b);
    return slideA && slideB ? slideA->slider == slideB->slider : a == b;
}
} // namespace vr
