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

/// Runs a class in the window: one turn after another, each saved before the next begins. Thread: gui.
///
/// A turn's work is in the class's own journal until it is archived. Works left in the journal by a crash are archived
/// before the first turn.
class ClassroomMode : public QObject
{
    Q_OBJECT

public:
    struct Program
    {
        ui::MainWindow* window;
        Document* document;
        RecoveryStore* recoveryStore; ///< store for ClassPaths::journals
    };

    /// Owns none of the pointers. All must outlive this, but the window may already be in its destructor. `nowMs`: a
    /// clock, of which only differences are used.
    ClassroomMode(const Program& program, ui::Classroom classroom, ClassPaths paths,
                  std::function<qint64()> nowMs = monotonicMs);
    ~ClassroomMode() override;

    static qint64 monotonicMs();

    /// Starts the class. Called once, when the window is shown.
    void begin();
    /// Updates the clocks and emits due notices. Called every second.
    void tick();

Q_SIGNALS:
    /// Emitted with one sentence to be shown in the window and the headset.
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
    Stage m_before = Stage::Recovering; ///< the stage before Saving
    RecoveryOffer m_offer;
    bool m_hasStartedRecovery = false; ///< whether works left by an earlier run are being archived
    bool m_canLeave = false;
    TurnRecord m_recordBefore;          ///< steps made before the document's history begins
    std::optional<EndedTurn> m_resumed; ///< work from which the present turn was resumed; none: it was not resumed
    TurnClock m_clock;                  ///< clock of the present turn; has no turn in stages Recovering and Asking
    std::function<void()> m_then;       ///< to be called when the model being opened is there
    bool m_isOpened = false;            ///< true: the model is open, and m_then is called next
    TurnNote m_note{m_paths.turnNote};
    ClassLesson m_lesson;
    ClassWork m_work;
    ClassEnd m_end;
    TurnQuestions m_questions;
    QTimer m_tick;
};
} // namespace app
