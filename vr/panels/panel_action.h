#pragma once

#include "vr/input/button_presets.h"
#include "vr/openxr/wand_state.h"

#include "core/boolean/mesh_boolean.h"
#include "core/primitives/primitives.h"
#include "core/stroke/tool.h"

#include <QString>

#include <optional>
#include <variant>

namespace vr
{
enum class PanelKind { Tools, Color, Files, Settings, Performance, Notice, Lesson, Parts };
inline constexpr std::size_t panelKindCount = 8;

enum class SettingsPage { General, Haptics };
enum class PartsPage { List, Name, Shapes, Cut };

/// Commands without parameters.
enum class PanelCommand {
    Undo,
    Redo,
    RestoreModel, ///< restores the model as it was when it was opened
    InvertMask,
    ClearMask,
    SaveModel, ///< saves under a new number
    Recentre,
    LevelModel, ///< turns the model until its Y axis is vertical
    LeaveVr,
    IsolatePart, ///< shows only the active part, or again those that were shown before
    ShowAllParts,
    DuplicatePart,
    DeletePart,
    ApplyPreview, ///< keeps the combination of parts that is shown, as one step
    CancelPreview ///< leaves the parts as they were
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

/// Makes the next stroke add a ball, or the stamp's model.
struct AddNext
{
    bool isOn = true;
    bool operator==(const AddNext&) const = default;
};

struct ChooseRadial
{
    int count = 1; ///< number of sectors; 1: no radial symmetry
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
    int page = 0; ///< page of the files panel
    bool operator==(const ShowPage&) const = default;
};

/// Turns to a page of the text of a lesson's step.
struct ShowLessonPage
{
    int page = 0;
    bool operator==(const ShowLessonPage&) const = default;
};

/// Requests of a pupil in a lesson.
enum class LessonRequest {
    Play,  ///< plays or pauses the teacher's strokes
    TryIt, ///< takes back what was done in the step
    Back,
    Next
};

/// Selects a file, which may then be opened.
struct ChooseFile
{
    QString path;
    bool operator==(const ChooseFile&) const = default;
};

struct OpenFile
{
    QString path;
    bool discardsChanges = false; ///< the item warned that changes will be lost, and had to be held
    bool operator==(const OpenFile&) const = default;
};

/// Turns to a page of the list of parts.
struct ShowPartsPage
{
    int page = 0;
    bool operator==(const ShowPartsPage&) const = default;
};

/// Makes a part the active one.
struct ChoosePart
{
    core::PartId part = 0;
    bool operator==(const ChoosePart&) const = default;
};

/// Marks a part, which is then combined with the active one.
struct MarkPart
{
    core::PartId part = 0;
    bool isMarked = true;
    bool operator==(const MarkPart&) const = default;
};

struct ShowPart
{
    core::PartId part = 0;
    bool isShown = true;
    bool operator==(const ShowPart&) const = default;
};

struct LockPart
{
    core::PartId part = 0;
    bool isLocked = true;
    bool operator==(const LockPart&) const = default;
};

/// Gives the active part a name.
struct NamePart
{
    QString name;
    bool operator==(const NamePart&) const = default;
};

/// Gives the active part a colour that marks it in lists, or takes it away.
struct TagPart
{
    std::optional<core::Rgb> tag;
    bool operator==(const TagPart&) const = default;
};

/// Makes a shape, or what the blade cuts off, a part of its own.
struct MakePart
{
    bool isOn = true;
    bool operator==(const MakePart&) const = default;
};

/// Shows the active part combined with the marked ones. During a preview: shows the result of this operation instead.
struct CombineMarked
{
    core::SetOperation operation = core::SetOperation::Union;
    bool operator==(const CombineMarked&) const = default;
};

/// Chooses the hand that sculpts.
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

/// Shows or hides the grid on the floor.
struct ShowFloor
{
    bool isShown = true;
    bool operator==(const ShowFloor&) const = default;
};

/// Shows or hides the real room behind the model.
struct ShowPassthrough
{
    bool isShown = true;
    bool operator==(const ShowPassthrough&) const = default;
};

enum class PanelSlider {
    Red, ///< Red, Green and Blue: whole numbers of 0 to 255, in the order of channels
    Green,
    Blue,
    Radius,    ///< of the brush in the room: doublings of vr::minRadius
    Height,    ///< metres that the model is raised
    TurnSpeed, ///< degrees a second
    Contact,   ///< Contact and all following sliders: levels of 0 to 1, in the order of Sensation
    Texture,
    Fusion,
    Refusal,
    MenuStep,
    Hold
};

struct Slide
{
    PanelSlider slider = PanelSlider::Red;
    double value = 0; ///< value in the slider's unit and range
    bool operator==(const Slide&) const = default;
};

/// A request that the user makes through an item of a panel.
using PanelAction = std::variant<PanelCommand, core::Tool, core::BrushShape, core::Topology, ButtonPreset, SettingsPage,
                                 ShowPanel, AddNext, ChooseSymmetry, ChooseRadial, ChooseChannel, ChooseColor, ShowPage,
                                 ChooseFile, OpenFile, ChooseHand, ShowPerformance, ShowFloor, ShowPassthrough, Slide,
                                 ShowLessonPage, LessonRequest, ShowPartsPage, ChoosePart, MarkPart, ShowPart, LockPart,
                                 NamePart, TagPart, MakePart, CombineMarked, PartsPage, core::Primitive::Kind>;

/// Returns whether both actions belong to the same item. A slider has an action for each of its values.
inline bool isSameItem(const PanelAction& a, const PanelAction& b)
{
    const auto *slideA = std::get_if<Slide>(&a), *slideB = std::get_if<Slide>(&b);
    return slideA && slideB ? slideA->slider == slideB->slider : a == b;
}
} // namespace vr
