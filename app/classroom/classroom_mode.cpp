#include "app/classroom/classroom_mode.h"

#include "app/classroom/class_pin.h"
#include "app/document/document.h"
#include "app/model/model_loader.h"

#include "ui/classroom/class_clock.h"
#include "ui/classroom/pin_dialog.h"
#include "ui/classroom/pupil_name_panel.h"
#include "ui/classroom/turn_countdown.h"
#include "ui/viewport/viewport.h"
#include "ui/window/main_window.h"

#include <QElapsedTimer>
#include <QEvent>
#include <QUuid>

#include <utility>

namespace app
{
namespace
{
constexpr int tickMs = 1000;
constexpr qint64 minuteMs = 60'000;

QString newId()
{
    return QUuid::createUuid().toString(QUuid::WithoutBraces);
}

/// Returns the pupil's name, or "somebody", for use in a sentence.
QString nameOf(const ClassTurn& turn)
{
    return turn.pupil.isEmpty() ? ClassroomMode::tr("somebody") : turn.pupil;
}

/// Adds the countdown over the view and the clock window for a projector.
void addClocks(const ui::Classroom& classroom, ui::ClassBar* bar, ClassWork* work, ui::MainWindow* window)
{
    auto* countdown = new ui::TurnCountdown(window->viewport());
    QObject::connect(bar, &ui::ClassBar::timeShown, countdown, &ui::TurnCountdown::setTime);
    auto* clock = new ui::ClassClock(classroom.title, classroom.names, window);
    QObject::connect(bar, &ui::ClassBar::clockRequested, clock, &ui::ClassClock::toggle);
    QObject::connect(bar, &ui::ClassBar::pupilShown, clock, &ui::ClassClock::setPupil);
    QObject::connect(bar, &ui::ClassBar::timeShown, clock, &ui::ClassClock::setTime);
    QObject::connect(work, &ClassWork::pupilsFound, clock, &ui::ClassClock::setHadTurn);
}
} // namespace

qint64 ClassroomMode::monotonicMs()
{
    static const QElapsedTimer clock = [] {
        QElapsedTimer begun;
        begun.start();
        return begun;
    }();
    return clock.elapsed();
}

ClassroomMode::ClassroomMode(const Program& program, ui::Classroom classroom, ClassPaths paths,
                             std::function<qint64()> nowMs)
    : m_program(program)
    , m_classroom(std::move(classroom))
    , m_paths(std::move(paths))
    , m_bar(new ui::ClassBar(m_classroom.title, program.window))
    , m_panel(new ui::PupilNamePanel(m_classroom, program.window->commands(), program.window->centralWidget()))
    , m_pinPrompt(new ui::PinPrompt([record = m_classroom.pin](const QString& text) { return isPin(text, record); },
                                    program.window))
    , m_clock({m_classroom.turnMinutes, m_classroom.warningMinutes}, std::move(nowMs))
    , m_lesson(m_classroom.lesson, program.window, program.document)
    , m_work(program.document, m_bar, {m_classroom.folder, m_paths.outbox})
    , m_end(&m_work, program.window)
    , m_questions(&m_work, program.window->centralWidget())
{
    program.window->setClassroom(m_classroom);
    program.window->installEventFilter(this);
    Document* document = program.document;
    connect(document, &Document::opened, this, [this] { m_isOpened = true; });
    const auto onOpened = [this] {
        m_isOpened = false;
        if (const auto then = std::exchange(m_then, nullptr))
            then();
    };
    connect(document, &Document::opened, this, onOpened, Qt::QueuedConnection);
    const auto checkIdle = [this] { // opening was cancelled, or failed, which the window reports
        if (m_isOpened || m_program.document->job().isBusy() || !std::exchange(m_then, nullptr))
            return;
        if (m_stage != Stage::Asking) // in stage Asking the questions or the name panel are already open
            m_panel->open();
        openClay();
    };
    connect(&document->job(), &BackgroundJob::idle, this, checkIdle, Qt::QueuedConnection);
    addClocks(m_classroom, m_bar, &m_work, program.window);
    connect(m_bar, &ui::ClassBar::nextRequested, this, &ClassroomMode::next);
    connect(m_bar, &ui::ClassBar::resumeRequested, this, &ClassroomMode::resume);
    connect(m_bar, &ui::ClassBar::leaveRequested, this, &ClassroomMode::leave);
    connect(m_panel, &ui::PupilNamePanel::begun, this, &ClassroomMode::prepareTurn);
    connect(&m_questions, &TurnQuestions::done, m_panel, &ui::PupilNamePanel::open);
    connect(m_program.recoveryStore, &RecoveryStore::offered, this, &ClassroomMode::onRecoveryOffered);
    connect(document, &Document::stepped, this, [this] {
        if (m_stage == Stage::Sculpting)
            m_work.forgetEnded();
        tick();
    });
    connect(&document->job(), &BackgroundJob::busy, m_bar, [this] { m_bar->setBusy(true); });
    connect(&document->job(), &BackgroundJob::idle, m_bar, [this] { m_bar->setBusy(false); });
    connect(&m_work, &ClassWork::pupilsFound, m_panel, &ui::PupilNamePanel::setHadTurn);
    connect(&m_work, &ClassWork::noticed, this, &ClassroomMode::noticed);
    connect(&m_tick, &QTimer::timeout, this, &ClassroomMode::tick);
    document->opener().setDiscardPrompt([this](const std::function<void()>& proceed) {
        saveThen(m_stage == Stage::Sculpting ? m_clock.turn() : ClassTurn{newId(), {}, {}, 0}, proceed);
        return false;
    });
    program.window->setGuard([this] {
        if (!m_canLeave)
            leave();
        return m_canLeave;
    });
}

ClassroomMode::~ClassroomMode() = default;

/// Calls `open`, which opens a model in the document, and calls `then` when the model is open. Further calls wait until
/// `then` has been called.
void ClassroomMode::openThen(const std::function<void()>& open, const std::function<void()>& then)
{
    if (m_then) {
        m_then = [this, open, then] { openThen(open, then); };
        return;
    }
    m_then = then;
    open();
}

void ClassroomMode::begin()
{
    if (m_lesson.isThere())
        m_panel->offerLesson(m_lesson.card());
    m_tick.start(tickMs);
    m_work.begin();
    show();
    m_program.recoveryStore->findAbandoned();
}

// --- works that an earlier run left

/// Starts archiving with the first offer. Later offers arrive as each one is taken from the store.
void ClassroomMode::onRecoveryOffered(const RecoveryOffer& offer)
{
    m_offer = offer;
    if (m_stage == Stage::Recovering && !std::exchange(m_hasStartedRecovery, true))
        recoverNext();
}

void ClassroomMode::recoverNext()
{
    if (m_offer.id == 0) {
        m_panel->open();
        return openClay();
    }
    const RecoveryOffer offer = m_offer;
    openThen([this, offer] { m_program.document->opener().recover(offer.id, offer.name); },
             [this, offer] { saveRecovered(offer); });
}

/// Archives a recovered work. The steps made before a turn was resumed are no longer known.
void ClassroomMode::saveRecovered(const RecoveryOffer& offer)
{
    const auto note = m_note.read(offer.changed);
    const bool isNoted = note && note->pupil == offer.name;
    m_recordBefore.reset();
    if (isNoted && !note->isResumed)
        m_recordBefore.emplace();
    ClassTurn turn = isNoted ? *note : ClassTurn{newId(), offer.name, {}, 0, offer.changed};
    if (turn.lesson)
        turn.lesson = m_lesson.find(*turn.lesson);
    saveThen(turn, [this] { recoverNext(); });
}

// --- turns

/// Opens a model for the next pupil: the first starter, or the lesson's model if the class has no starters. The name
/// panel or the questions cover it.
void ClassroomMode::openClay()
{
    m_stage = Stage::Asking;
    m_clock.clear();
    m_recordBefore.emplace();
    const auto open = [this] {
        if (m_classroom.starters.isEmpty())
            m_lesson.open();
        else
            m_program.document->opener().openStarter(m_classroom.starters.constFirst());
    };
    openThen(open, [this] { m_program.window->beginTurn(); });
    show();
}

void ClassroomMode::prepareTurn(const QString& pupil, const std::optional<core::Starter>& starter)
{
    if (m_stage != Stage::Asking)
        return;
    openThen([this, starter] { starter ? m_program.document->opener().openStarter(*starter) : m_lesson.open(); },
             [this, pupil, starter] {
                 m_program.window->beginTurn();
                 m_program.document->setName(pupil);
                 startTurn({newId(), pupil, QDateTime::currentDateTime(), 0}, TurnRecord(std::in_place));
                 if (!starter)
                     m_lesson.begin();
                 tick();
             });
}

void ClassroomMode::startTurn(const ClassTurn& turn, const TurnRecord& before)
{
    m_stage = Stage::Sculpting;
    m_clock.start(turn);
    m_resumed.reset();
    m_recordBefore = before;
    m_note.write(turn);
    m_questions.finish();
    m_panel->close();
    show();
}

/// Saves the turn, then asks the class's questions, if it has any, and then for the next pupil's name.
void ClassroomMode::next()
{
    if (m_stage != Stage::Sculpting)
        return;
    saveThen(m_clock.turn(), [this] {
        if (m_classroom.asksQuestions)
            m_questions.ask(*m_work.ended());
        else
            m_panel->open();
        openClay();
    });
}

void ClassroomMode::resume()
{
    if (!m_work.ended() || (m_stage != Stage::Asking && m_stage != Stage::Sculpting))
        return;
    EndedTurn ended = *m_work.ended();
    ended.turn.isResumed = true;
    const auto make = [archive = m_work.archive(), ended](const core::JobControl& control) {
        LoadedModel model;
        for (int attempt = 0; attempt < 2 && !model.sculptor && !control.isCancelled();
             ++attempt) // a second attempt, in case the work is delivered between locate() and load()
            model = ModelLoader::load(archive.locate(ended.folder, ended.turn.id) + QStringLiteral("/model.glb"), {},
                                      control);
        model.path.clear();
        model.name = ended.turn.pupil;
        return model;
    };
    openThen(
        [this, ended, make] {
            m_program.document->opener().openMade(
                {tr("Opening the work of %1").arg(nameOf(ended.turn)), make, {}, false});
        },
        [this, ended] {
            m_work.forgetEnded();
            startTurn(ended.turn, ended.record);
            m_resumed = ended;
            if (ended.turn.lesson)
                m_lesson.resume(*ended.turn.lesson);
        });
}

// --- keeping the work

/// Saves the turn's work and calls `then` if it is safe. Otherwise the model stays open and an error is shown.
void ClassroomMode::saveThen(ClassTurn turn, std::function<void()> then)
{
    if (m_stage == Stage::Saving)
        return;
    m_program.window->viewport()->input()->finish();
    m_program.document->changer().dropPreview();
    if (m_stage == Stage::Sculpting) // a turn recovered after a crash already has its place, from the note
        turn.lesson = m_lesson.stop();
    Document& document = *m_program.document;
    const auto stepOf = [](const ClassTurn& of) { return of.lesson ? of.lesson->step : 0; };
    if (m_resumed && m_stage == Stage::Sculpting && document.queue().isSettled() &&
        // nothing was changed since the saved work
        document.history().stack().index() == 0 && stepOf(turn) == stepOf(m_resumed->turn)) {
        EndedTurn unchanged = *m_resumed;
        unchanged.turn.usedMs = turn.usedMs;
        m_work.setEnded(unchanged);
        return then();
    }
    const auto done = [this, then = std::move(then)](const EndedTurn& ended, const QString& problem) {
        onSaved(ended, problem, then);
    };
    if (m_work.save(tr("Saving the work of %1").arg(nameOf(turn)), turn, m_recordBefore, done)) {
        m_before = std::exchange(m_stage, Stage::Saving);
        return;
    }
    m_canLeave = false;
    Q_EMIT noticed(tr("Please wait: another operation on the model is still running."));
}

void ClassroomMode::onSaved(const EndedTurn& ended, const QString& problem, const std::function<void()>& then)
{
    m_stage = m_before;
    if (!problem.isEmpty()) {
        m_canLeave = false;
        return m_program.window->showProblem(
            tr("%1 The work of %2 stays open; nothing is lost.").arg(problem, nameOf(ended.turn)));
    }
    EndedTurn resumable = ended;
    resumable.turn.ended = {};
    m_work.setEnded(resumable);
    then();
}

// --- leaving the class

void ClassroomMode::leave()
{
    m_pinPrompt->ask(m_end.question(m_stage != Stage::Asking), [this] {
        const auto end = [this] {
            m_end.end([this] {
                m_canLeave = true;
                m_program.window->close();
            });
        };
        m_questions.finish();
        if (m_stage != Stage::Sculpting)
            end();
        else
            saveThen(m_clock.turn(), [this, end] {
                m_stage = Stage::Asking;
                end();
            });
    });
}

/// Restores a full-screen window that a window manager's shortcut has minimised or resized.
bool ClassroomMode::eventFilter(QObject* watched, QEvent* event)
{
    const ui::MainWindow& window = *m_program.window;
    const bool isAway = event->type() == QEvent::WindowStateChange && (!window.isFullScreen() || window.isMinimized());
    if (isAway && m_classroom.fullScreen && window.isVisible())
        QMetaObject::invokeMethod(m_program.window, &QWidget::showFullScreen, Qt::QueuedConnection);
    return QObject::eventFilter(watched, event);
}

// --- the clock

/// Also notes the place in the lesson, which can change without a step of the document.
void ClassroomMode::tick()
{
    if (m_stage == Stage::Sculpting) {
        ClassTurn turn = m_clock.turn();
        turn.lesson = m_lesson.place();
        m_note.update(turn);
    }
    if (m_stage == Stage::Sculpting && m_clock.hasEnd()) {
        const TurnClock::Notice notice = m_clock.takeNotice();
        if (notice == TurnClock::Notice::Over)
            Q_EMIT noticed(tr("Time is up. Please finish: it is the next pupil's turn."));
        else if (notice == TurnClock::Notice::Warning)
            Q_EMIT noticed(tr("%n minutes left. Please finish soon.", nullptr,
                              static_cast<int>((m_clock.remainingMs() + minuteMs - 1) / minuteMs)));
    }
    show();
}

void ClassroomMode::show()
{
    const bool isTurn = m_stage == Stage::Sculpting || (m_stage == Stage::Saving && m_before == Stage::Sculpting);
    m_bar->setPupil(isTurn ? std::optional(m_clock.pupil()) : std::nullopt);
    m_bar->setResumable(m_work.ended() && m_stage != Stage::Recovering ? std::optional(nameOf(m_work.ended()->turn))
                                                                       : std::nullopt);
    std::optional<ui::TurnTime> time;
    if (isTurn && m_clock.hasEnd())
        time = {static_cast<int>((m_clock.remainingMs() + 999) / 1000), m_clock.isWarned(),
                static_cast<int>(m_clock.overMs() / 1000)};
    m_bar->setTime(time);
}
} // namespace app
