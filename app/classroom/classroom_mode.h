#pragma once

#include "app/classroom/class_end.h"
#include "app/classroom/class_lesson.h"
#include "app/classroom/class_paths.h"
#include "app/classroom/class_work.h"
#include "app/classroom/turn_clock.h"
#include "app/classroom/turn_note.h"
#include "app/classroom/turn_questions.h"
#include "app/recovery/recovery_store.h"

#include "ui/classroom/class_bar.h"
#include "ui/classroom/classroom.h"

#include <QObject>
#include <QTimer>

#include <functional>

namespace ui
{
class MainWindow;
class PupilNamePanel;
class PinPrompt;
} // namespace ui

namespace app
{
class Document;

/// A class in the window: turn after turn, each saved before the next begins. Thread: gui.
///
/// A turn's work is in its journal, which is the class's own, until it is in the archive; what a program that ended
/// otherwise left there is archived before the first turn.
class ClassroomMode : public QObject
{
    Q_OBJECT

public:
    struct Program
    {
        ui::MainWindow* window;
        Document* document;
        RecoveryStore* recoveryStore; ///< of ClassPaths::journals
    };

    /// None is owned, and all outlive the mode but the window, which may be just going. Of `nowMs` only differences
    /// count.
    ClassroomMode(const Program& program, ui::Classroom classroom, ClassPaths paths,
                  std::function<qint64()> nowMs = monotonicMs);
    ~ClassroomMode() override;

    static qint64 monotonicMs();

    /// Once, when the window is there.
    void begin();
    /// What the clock says is shown and said.
    void tick();

Q_SIGNALS:
    /// One sentence, for the window and the headset.
    void noticed(const QString& sentence);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    enum class Stage { Recovering, Asking, Sculpting, Saving };

    void openThen(const std::function<void()>& open, const std::function<void()>& then);
    void onRecoveryOffered(const RecoveryOffer& offer);
    void recoverNext();
    void saveRecovered(const RecoveryOffer& offer);
    void openClay();
    void prepareTurn(const QString& pupil, const std::optional<core::Starter>& starter);
    void startTurn(const ClassTurn& turn, const TurnRecord& before);
    void next();
    void resume();
    void leave();
    void saveThen(ClassTurn turn, std::function<void()> then);
    void onSaved(const EndedTurn& ended, const QString& problem, const std::function<void()>& then);
    void show();

    Program m_program;
    ui::Classroom m_classroom;
    ClassPaths m_paths;
    ui::ClassBar* m_bar;
    ui::PupilNamePanel* m_panel;
    ui::PinPrompt* m_pinPrompt;
    Stage m_stage = Stage::Recovering;
    Stage m_before = Stage::Recovering; ///< of Saving
    RecoveryOffer m_offer;
    bool m_hasStartedRecovery = false; ///< for works that an earlier run left
    bool m_canLeave = false;
    TurnRecord m_recordBefore;          ///< of what was done before the document's history begins
    std::optional<EndedTurn> m_resumed; ///< the turn goes on from this work
    TurnClock m_clock;                  ///< of Sculpting; else nobody's turn
    std::function<void()> m_then;       ///< for the model that is being opened
    bool m_isOpened = false;            ///< that model is there, and m_then comes next
    TurnNote m_note{m_paths.turnNote};
    ClassLesson m_lesson;
    ClassWork m_work;
    ClassEnd m_end;
    TurnQuestions m_questions;
    QTimer m_tick;
};
} // namespace app
