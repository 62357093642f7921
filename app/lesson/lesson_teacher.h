#pragma once

#include "core/lesson/lesson_player.h"

#include <QElapsedTimer>
#include <QObject>
#include <QPointer>
#include <QTimer>

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
    const core::LessonStep& step() const { return m_player->step(); }
    std::size_t stepIndex() const { return m_player->stepIndex(); }
    /// Something was done since the step was entered.
    bool hasChanges() const;
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
    void setPlaying(bool isPlaying);
    void endStroke();
    void tick();
    void run(const core::LessonCue& cue);
    bool isBehind() const;
    void placeGhost();
    void showGhost(const std::optional<core::Sphere>& ghost);

    QPointer<ui::MainWindow> m_window;
    QPointer<ui::LessonPanel> m_panel;
    Document* m_document;
    std::optional<core::LessonPlayer> m_player; ///< while a lesson is open
    std::vector<int> m_starts;                  ///< index of the undo stack where each step up to this one was entered
    double m_speed = 1;
    bool m_isTaught = false;                    ///< the teacher is in the middle of the step
    bool m_isStrokeOpen = false;                ///< the teacher's
    quint64 m_posted = 0, m_consumedBefore = 0; ///< the stroke's samples
    bool m_isGhostAsked = false;
    QTimer m_timer;
    QElapsedTimer m_sinceTick;
};
} // namespace app
