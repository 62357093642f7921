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

/// Plays the teacher's part of a lesson: its strokes and commands go into the document as steps to undo. A stroke by
/// hand stops it. Thread: gui.
class LessonTeacher : public QObject
{
    Q_OBJECT

public:
    /// All must outlive it, except the window.
    LessonTeacher(ui::MainWindow& window, Document& document);

    /// Null ends the lesson. The first step is still to be entered.
    void setLesson(std::shared_ptr<const core::Lesson> lesson);
    bool hasLesson() const { return m_player.has_value(); }
    const core::LessonStep& step() const { return m_player->lesson().steps[stepIndex()]; }
    std::size_t stepIndex() const { return m_entered.value_or(m_player->stepIndex()); }
    enum class Hand { Nobodys, Pupils, Teachers };
    /// Returns whose changes the model has since the step was entered: the teacher's, if any stroke of it is.
    Hand changedBy() const;
    /// Does at once what is left of a step that the teacher is in the middle of, then calls `done`; not if a hand goes
    /// between, or the teacher is paused or asked for a single stroke meanwhile.
    void finish(std::function<void()> done);
    /// Begins the step anew from the model that the teacher has there, as steps to undo; then calls `done`. If a hand
    /// goes between, these steps belong to the step, as what the teacher has shown.
    void startFromOwn(std::function<void()> done);
    /// Enters the step with the model as it is.
    void enter(std::size_t step);
    /// Goes back to an earlier step and to the model as it was when that one was entered.
    void goBack(std::size_t step);

public Q_SLOTS:
    void play(bool on);
    void playOne();
    void setSpeed(double speed);
    /// Takes back what was done in the step: it is the pupil's turn.
    void tryIt();
    /// Stops, in the middle of a stroke, too.
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
    std::optional<core::LessonPlayer> m_player; ///< while a lesson is open
    std::vector<int> m_starts;                  ///< index of the undo stack where each step up to this one was entered
    LessonCamera m_camera;
    double m_speed = 1;
    bool m_isTaught = false;                    ///< the teacher is in the middle of the step
    bool m_isUndone = false;                    ///< the teacher's strokes of the step were undone, and may come back
    bool m_hasShown = false;                    ///< the model has strokes of the teacher's since the step was entered
    std::function<void()> m_afterHurry;         ///< null: the teacher does not hurry
    std::optional<std::size_t> m_entered;       ///< the step to begin with what the teacher does in a hurry
    bool m_isStrokeOpen = false;                ///< the teacher's
    quint64 m_posted = 0, m_consumedBefore = 0; ///< the stroke's samples
    bool m_isGhostAsked = false;
    QTimer m_timer;
    QElapsedTimer m_sinceTick;
};
} // namespace app
