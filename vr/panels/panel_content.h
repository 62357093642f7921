#pragma once

#include "vr/panels/panel_layout.h"

#include "vr/frame/frame_timing.h"
#include "vr/input/headset_settings.h"

#include <QCoreApplication>
#include <QList>

#include <array>

namespace vr
{
class PanelBuilder;

// What panels show: values. Equal values have equal pictures, in one language.

/// At the hand that does not sculpt.
struct ToolPanel
{
    Q_DECLARE_TR_FUNCTIONS(vr::ToolPanel)

public:
    core::Tool tool = core::Tool::Pull;
    core::BrushShape brush = core::BrushShape::Sphere;
    core::Topology topology = core::Topology::Adaptive;
    bool isSymmetric = false;
    int radial = 1;         ///< sectors
    bool isInverse = false; ///< strokes do the opposite
    bool addsNext = false;  ///< the next stroke adds a ball
    bool canUndo = false, canRedo = false;
    bool canChange = true; ///< the model as a whole: restore it, or change its mask

    bool operator==(const ToolPanel&) const = default;
    PanelLayout layout() const;

private:
    static QString nameOf(core::Tool tool);
    void addTools(PanelBuilder& builder) const;
    void addSymmetry(PanelBuilder& builder) const;
    void addMask(PanelBuilder& builder) const;
    void addPanelButtons(PanelBuilder& builder) const;
};

/// The paint colour by its channels, as in the paper's section 4.1, or from a swatch.
struct ColorPanel
{
    Q_DECLARE_TR_FUNCTIONS(vr::ColorPanel)

public:
    static constexpr int maxSwatches = 12;

    core::Rgb color;
    int channel = 0;           ///< that the thumb sets: 0 red, 1 green, 2 blue
    QList<core::Rgb> swatches; ///< the first maxSwatches are shown

    bool operator==(const ColorPanel&) const = default;
    PanelLayout layout() const;

private:
    static QString nameOf(int channel);
};

struct FileTile
{
    QString path;          ///< tells tiles apart
    QString name;          ///< as people know it
    QImage picture;        ///< null: not made yet
    bool isBroken = false; ///< it cannot be read

    /// The same picture, not an equal one.
    bool operator==(const FileTile& other) const;
};

/// Models of a folder to open, and Save.
struct FilesPanel
{
    Q_DECLARE_TR_FUNCTIONS(vr::FilesPanel)

public:
    static constexpr int columns = 3, tilesPerPage = 2 * columns;

    QString folder; ///< its name, for people
    QList<FileTile> files;
    int page = 0;
    QString chosen;                 ///< a path
    bool hasUnsavedChanges = false; ///< which opening would lose
    bool isBusy = false;            ///< saving or opening
    QString saved;                  ///< what Save wrote last, for people

    bool operator==(const FilesPanel&) const = default;
    PanelLayout layout() const;
    int pageCount() const;
    /// After ShowPage or ChooseFile; others leave it as it is.
    FilesPanel after(const PanelAction& action) const;

private:
    int shownPage() const;
    bool canOpen() const;
    QString status() const;
    void addTiles(PanelBuilder& builder) const;
    void addButtons(PanelBuilder& builder) const;
};

struct SettingsPanel
{
    Q_DECLARE_TR_FUNCTIONS(vr::SettingsPanel)

public:
    static constexpr double maxHeightOffset = 0.4;               ///< metres up or down
    static constexpr double minTurnRate = 15, maxTurnRate = 180; ///< degrees a second

    SettingsPage page = SettingsPage::General;
    HeadsetSettings settings;

    static SettingsPanel of(const HeadsetSettings& settings, SettingsPage page) { return {page, settings}; }

    bool operator==(const SettingsPanel&) const = default;
    PanelLayout layout() const;
    /// Returns the settings after `action`. Values are clamped to their ranges; an action that is no setting changes
    /// nothing.
    static HeadsetSettings after(HeadsetSettings settings, const PanelAction& action);

private:
    static QString nameOf(Sensation sensation);
    static void slide(HeadsetSettings& settings, const Slide& slide);
    void addGeneral(PanelBuilder& builder) const;
    void addModel(PanelBuilder& builder) const;
    void addHaptics(PanelBuilder& builder) const;
};

/// Numbers, from time to time.
struct PerformancePanel
{
    Q_DECLARE_TR_FUNCTIONS(vr::PerformancePanel)

public:
    // Medians over frames, in milliseconds of the headset's thread; the phases and their sum without draw calls.
    std::array<double, framePhaseCount> cpuMs{}; ///< by FramePhase
    double totalMs = 0;
    double drawCallMs = 0;
    int framesPerSecond = 0; ///< that were shown
    std::uint64_t dropped = 0;

    /// Of the last second. `timings`: the oldest first. Takes some microseconds; numbers that are to be read change a
    /// few times a second.
    static PerformancePanel of(const std::vector<FrameTiming>& timings, std::uint64_t droppedFrames);

    bool operator==(const PerformancePanel&) const = default;
    PanelLayout layout() const;

private:
    static QString nameOf(FramePhase phase);
};

/// One thing that a lesson's step asks for.
struct LessonMark
{
    QString text;
    bool holds = false;

    bool operator==(const LessonMark&) const = default;
};

/// A step of the lesson that is open in the window. A text that is too long for the panel has pages: no letter is
/// smaller than another panel's.
struct LessonPanel
{
    Q_DECLARE_TR_FUNCTIONS(vr::LessonPanel)

public:
    QString lesson, title, text;
    int step = 0; ///< from 0; `steps`: the page after the last
    int steps = 1;
    QList<LessonMark> marks;
    bool canPlay = false; ///< the teacher has strokes for it
    bool isPlaying = false;
    int page = 0; ///< of the text; beyond the last it is the last

    bool operator==(const LessonPanel&) const = default;
    PanelLayout layout() const;

private:
    void addTitle(PanelBuilder& builder) const;
    void addText(PanelBuilder& builder) const;
    void addMarks(PanelBuilder& builder) const;
    void addButtons(PanelBuilder& builder) const;
};

/// One sentence.
struct NoticePanel
{
    QString text;

    bool operator==(const NoticePanel&) const = default;
    PanelLayout layout() const;
};
/// Of a notice that was shown so many seconds ago: 0 before and after its time, which is long enough to read it.
double noticeOpacity(const NoticePanel& notice, double age);

using PanelContent =
    /// By PanelKind.
    std::variant<ToolPanel, ColorPanel, FilesPanel, SettingsPanel, PerformancePanel, NoticePanel, LessonPanel>;

PanelKind kindOf(const PanelContent& content);
PanelLayout layoutOf(const PanelContent& content);
} // namespace vr
