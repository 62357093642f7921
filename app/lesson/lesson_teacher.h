#pragma once

#include "app/lesson/lesson_camera.h"

#include "core/lesson/lesson_player.h"

#include <QElapsedTimer>
#include <QObject>
#include <QPointer>
#include <QTimer>

#include <functional>
#include <optional>

namespace ui
{
class LessonPanel;
class MainWindow;
} // namespace ui

namespace app
{
class Document;

/// Plays the demonstration of a lesson: the teacher's strokes and commands become undo steps of the document. A stroke
/// by the user stops it. Thread: gui.
class LessonTeacher : public QObject
{
    Q_OBJECT

public:
    /// All arguments must outlive this, except the window.
    LessonTeacher(ui::MainWindow& window, Document& document);

    /// Sets the lesson; null ends it. The first step must then be entered by enter().
    void setLesson(std::shared_ptr<const core::Lesson> lesson);
    bool hasLesson() const { return m_player.has_value(); }
    const core::LessonStep& step() const { return m_player->lesson().steps[stepIndex()]; }
    std::size_t stepIndex() const { return m_entered.value_or(m_player->stepIndex()); }
    enum class Hand { Nobodys, Pupils, Teachers };
    /// Returns who has changed the model since the step was entered. Teachers if it contains any stroke of the
    /// demonstration.
    Hand changedBy() const;
    /// Completes a demonstration in progress at full speed, then calls `done`. Does not call `done` if the user
    /// sculpts, pauses, or asks for a single stroke meanwhile.
    void finish(std::function<void()> done);
    /// Begins the step with the teacher's model for it, made as undo steps at full speed; then calls `done`. If the
    /// user sculpts meanwhile, these undo steps count as demonstration in this step.
    void startFromOwn(std::function<void()> done);
    /// Enters the step with the present model.
    void enter(std::size_t step);
    /// Returns to an earlier step, and to the model as it was when that step was entered.
    void goBack(std::size_t step);

public Q_SLOTS:
    void play(bool on);
    void playOne();
    void setSpeed(double speed);
    /// Undoes what was done in this step, for the pupil to try it.
    void tryIt();
    /// Stops the demonstration, even in the middle of a stroke.
    void interrupt();

private:
    void startStep();
    void hurry(std::function<void()> done);
    void tickInHurry();
    void goOnInHurry();
    void onIndexChanged(int index);
    void setPlaying(bool isPlaying);
    void endStroke();
    void tick();
    void run(const core::LessonCue& cue);
    bool isBehind() const;
    void placeGhost();
    void showGhost(const std::optional<core::GhostBrush>& ghost, const core::Vec3& at = core::Vec3::Zero());

    QPointer<ui::MainWindow> m_window;
    QPointer<ui::LessonPanel> m_panel;
    Document* m_document;
    std::optional<core::LessonPlayer> m_player; ///< exists while a lesson is open
    std::vector<int> m_starts;                  ///< undo index at which each step up to the present one was entered
    LessonCamera m_camera;
    double m_speed = 1;
    bool m_isTaught = false; ///< whether the demonstration of this step has begun and not ended
    bool m_isUndone = false; ///< whether strokes of the demonstration in this step were undone and can be redone
    bool m_hasShown = false; ///< whether the model contains strokes of the demonstration in this step
    std::function<void()> m_afterHurry; ///< to be called after playing at full speed; null: normal speed
    /// step whose starting model is being made at full speed; none: no such model is being made
    std::optional<std::size_t> m_entered;
    bool m_isStrokeOpen = false;                ///< whether a stroke of the demonstration is open
    quint64 m_posted = 0, m_consumedBefore = 0; ///< samples posted for the open stroke, and samples consumed before it
    bool m_isGhostAsked = false;
    QTimer m_timer;
    QElapsedTimer m_sinceTick;
};
} // namespace app
