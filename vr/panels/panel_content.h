#pragma once

#include "vr/panels/panel_layout.h"

#include "vr/frame/frame_timing.h"
#include "vr/input/headset_settings.h"
#include "vr/input/wand_commands.h"

#include "core/parts/part_list.h"

#include <QCoreApplication>
#include <QList>

#include <array>

namespace vr
{
class PanelBuilder;

// Contents of the panels, as values. Equal values have equal pictures in the same language.

/// Content of the tool menu. It is attached to the hand that does not sculpt, except with ButtonPreset::OneHand.
struct ToolPanel
{
    Q_DECLARE_TR_FUNCTIONS(vr::ToolPanel)

public:
    core::Tool tool = core::Tool::Pull;
    core::BrushShape brush = core::BrushShape::Sphere;
    double radius = defaultRadius; ///< of the brush in the room, metres
    core::Topology topology = core::Topology::Adaptive;
    bool isSymmetric = false;
    int radial = 1;         ///< number of sectors
    bool isInverse = false; ///< strokes use the opposite of the tool
    bool addsNext = false;  ///< the next stroke adds a ball, or the stamp's model
    bool canUndo = false, canRedo = false;
    bool canChange = true; ///< the whole model can be changed: it can be restored, or its mask changed

    bool operator==(const ToolPanel&) const = default;
    PanelLayout layout() const;

private:
    static QString nameOf(core::Tool tool);
    void addTools(PanelBuilder& builder) const;
    void addBrush(PanelBuilder& builder) const;
    void addSymmetry(PanelBuilder& builder) const;
    void addMask(PanelBuilder& builder) const;
    void addPanelButtons(PanelBuilder& builder) const;
};

/// Content of the colour panel. The paint colour is set by channels, as in the paper's section 4.1, or by a swatch.
struct ColorPanel
{
    Q_DECLARE_TR_FUNCTIONS(vr::ColorPanel)

public:
    static constexpr int maxSwatches = 12;

    core::Rgb color;
    int channel = 0;           ///< channel that the thumb changes: 0 red, 1 green, 2 blue
    QList<core::Rgb> swatches; ///< swatches of the palette, of which the first maxSwatches are shown

    bool operator==(const ColorPanel&) const = default;
    PanelLayout layout() const;

private:
    static QString nameOf(int channel);
};

struct FileTile
{
    QString path;          ///< identifies the tile
    QString name;          ///< name for display
    QImage picture;        ///< null: the picture is not made yet
    bool isBroken = false; ///< the file cannot be read

    /// Compares pictures by identity, not by their pixels.
    bool operator==(const FileTile& other) const;
};

/// Content of the files panel: the models of a folder, which can be opened, and Save.
struct FilesPanel
{
    Q_DECLARE_TR_FUNCTIONS(vr::FilesPanel)

public:
    static constexpr int columns = 3, tilesPerPage = 2 * columns;

    QString folder; ///< name of the folder, for display
    QList<FileTile> files;
    int page = 0;
    QString chosen;                 ///< path of the chosen file
    bool hasUnsavedChanges = false; ///< opening another file would lose changes
    bool isBusy = false;            ///< the model is being opened, saved or changed as a whole
    QString saved;                  ///< name that Save used last, for display

    bool operator==(const FilesPanel&) const = default;
    PanelLayout layout() const;
    int pageCount() const;
    /// Returns the panel after ShowPage or ChooseFile. Other actions change nothing.
    FilesPanel after(const PanelAction& action) const;

private:
    int shownPage() const;
    bool canOpen() const;
    QString status() const;
    void addTiles(PanelBuilder& builder) const;
    void addButtons(PanelBuilder& builder) const;
};

struct PartRow
{
    core::Part part;
    QString name; ///< name for display

    bool operator==(const PartRow&) const = default;
};

/// Content of the parts panel. On one page are the parts of the model, of which one is active and others can be marked
/// to be combined with it; on others names and colours for the active part, the shapes that can be placed, and the
/// blade.
struct PartsPanel
{
    Q_DECLARE_TR_FUNCTIONS(vr::PartsPanel)

public:
    static constexpr int rowsPerPage = 5;

    QList<PartRow> parts;
    core::PartId active = 0;
    QList<core::PartId> marked; ///< may include ids that no part has any more
    int page = 0;
    bool canUndo = false, canRedo = false;
    bool isBusy = false; ///< the model is being opened, saved or changed as a whole
    /// How parts are combined in the result that is shown before it becomes a step; none: no preview.
    std::optional<core::SetOperation> preview;
    PartsPage shown = PartsPage::List;
    core::Primitive::Kind shape = core::Primitive::Kind::Cuboid; ///< shape that the trigger places
    bool makesPart = false; ///< a shape, or what the blade cuts off, becomes a part of its own

    bool operator==(const PartsPanel&) const = default;
    PanelLayout layout() const;
    int pageCount() const;
    /// Returns what the sculpting hand does while the panel is open.
    HandTask task() const;
    /// Returns the panel after ShowPartsPage, MarkPart, MakePart, PartsPage or Primitive::Kind. Other actions change
    /// nothing.
    PartsPanel after(const PanelAction& action) const;
    /// Returns the row of a part; null if there is no such part.
    const PartRow* find(core::PartId part) const;
    /// Returns the marked parts other than the active one, in the order of the list.
    std::vector<core::PartId> others() const;
    /// Returns the name of a copy of the active part.
    QString nameOfCopy() const;
    static QString nameOf(core::Primitive::Kind kind);

private:
    int shownPage() const;
    static QStringList readyNames();
    void addList(PanelBuilder& builder) const;
    void addNames(PanelBuilder& builder) const;
    void addShapes(PanelBuilder& builder) const;
    void addCut(PanelBuilder& builder) const;
    void addRow(PanelBuilder& builder, const PartRow* row) const;
    void addListButtons(PanelBuilder& builder) const;
    void addPartButtons(PanelBuilder& builder) const;
    void addCombinations(PanelBuilder& builder) const;
};

struct SettingsPanel
{
    Q_DECLARE_TR_FUNCTIONS(vr::SettingsPanel)

public:
    static constexpr double maxHeightOffset = 0.4;               ///< largest change of height, metres up or down
    static constexpr double minTurnRate = 15, maxTurnRate = 180; ///< range of the turning speed, degrees a second

    SettingsPage page = SettingsPage::General;
    HeadsetSettings settings;
    bool offersPassthrough = true; ///< the headset can show the real room

    static SettingsPanel of(const HeadsetSettings& settings, SettingsPage page) { return {page, settings}; }

    bool operator==(const SettingsPanel&) const = default;
    PanelLayout layout() const;
    /// Returns the settings after `action`. Values are clamped to their ranges; an action that is no setting changes
    /// nothing.
    static HeadsetSettings after(HeadsetSettings settings, const PanelAction& action);

private:
    static QString nameOf(Sensation sensation);
    static void slide(HeadsetSettings& settings, const Slide& slide);
    static SwitchLook onOff(bool isOn);
    void addGeneral(PanelBuilder& builder) const;
    void addPassthrough(PanelBuilder& builder) const;
    void addModel(PanelBuilder& builder) const;
    void addHaptics(PanelBuilder& builder) const;
};

/// Content of the performance panel: numbers that are updated from time to time.
struct PerformancePanel
{
    Q_DECLARE_TR_FUNCTIONS(vr::PerformancePanel)

public:
    // Medians over frames of the headset thread's CPU time, milliseconds. cpuMs and totalMs exclude draw calls.
    std::array<double, framePhaseCount> cpuMs{}; ///< indexed by FramePhase
    double totalMs = 0;
    double drawCallMs = 0;
    int framesPerSecond = 0; ///< number of frames shown per second
    std::uint64_t dropped = 0;

    /// Returns the numbers of the last second. `timings`: the oldest first. To be called a few times a second, because
    /// numbers that change faster cannot be read. Cost: some microseconds.
    static PerformancePanel of(const std::vector<FrameTiming>& timings, std::uint64_t droppedFrames);

    bool operator==(const PerformancePanel&) const = default;
    PanelLayout layout() const;

private:
    static QString nameOf(FramePhase phase);
};

/// One requirement of a lesson's step.
struct LessonMark
{
    QString text;
    bool holds = false;

    bool operator==(const LessonMark&) const = default;
};

/// Content of the lesson panel: a step of the lesson that is open in the window. A text that is too long for the panel
/// has pages, because its letters must not be smaller than those of other panels.
struct LessonPanel
{
    Q_DECLARE_TR_FUNCTIONS(vr::LessonPanel)

public:
    QString lesson, title, text;
    int step = 0; ///< number of the step, from 0; equal to `steps`: the page after the last step
    int steps = 1;
    QList<LessonMark> marks;
    bool canPlay = false; ///< the teacher has strokes for this step
    bool isPlaying = false;
    int page = 0; ///< page of the text; a number beyond the last page means the last page

    bool operator==(const LessonPanel&) const = default;
    PanelLayout layout() const;

private:
    void addTitle(PanelBuilder& builder) const;
    void addText(PanelBuilder& builder) const;
    void addMarks(PanelBuilder& builder) const;
    void addButtons(PanelBuilder& builder) const;
};

/// Content of the notice panel: one sentence.
struct NoticePanel
{
    QString text;

    bool operator==(const NoticePanel&) const = default;
    PanelLayout layout() const;
};
/// Returns the opacity of a notice that appeared `age` seconds ago. The opacity is 0 before and after the notice's
/// time, which is long enough to read it.
double noticeOpacity(const NoticePanel& notice, double age);

/// The content of any panel. The alternatives are in the order of PanelKind.
using PanelContent = std::variant<ToolPanel, ColorPanel, FilesPanel, SettingsPanel, PerformancePanel, NoticePanel,
                                  LessonPanel, PartsPanel>;

PanelKind kindOf(const PanelContent& content);
PanelLayout layoutOf(const PanelContent& content);
} // namespace vr
