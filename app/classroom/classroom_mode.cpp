#include "app/classroom/classroom_mode.h"

#include "app/classroom/class_pin.h"
#include "app/document/document.h"
#include "app/model/model_loader.h"

#include "ui/classroom/pin_dialog.h"
#include "ui/classroom/pupil_name_panel.h"
#include "ui/viewport/viewport.h"
#include "ui/window/main_window.h"

#include <QCryptographicHash>
#include <QDir>
#include <QElapsedTimer>
#include <QEvent>
#include <QFileInfo>
#include <QPointer>
#include <QStandardPaths>
#include <QUuid>

#include <algorithm>
#include <utility>

namespace app
{
namespace
{
constexpr int tickMs = 1000, retryMs = 60'000;
constexpr qint64 minuteMs = 60'000;
constexpr int keyLength = 16; ///< digits that tell class files from each other

/// As a part of a sentence.
QString nameOf(const ClassTurn& turn)
{
    return turn.pupil.isEmpty() ? ClassroomMode::tr("somebody") : turn.pupil;
}
} // namespace

ClassPaths ClassPaths::of(const QString& classFile)
{
    const QByteArray path = QFileInfo(classFile).canonicalFilePath().toUtf8();
    const QString key =
        QString::fromLatin1(QCryptographicHash::hash(path, QCryptographicHash::Sha256).toHex().left(keyLength));
    const QString own = QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation) +
                        QStringLiteral("/fettle/classes/") + key;
    return {RecoveryStore::defaultRoot().parent_path() / "class-journals" / key.toStdString(),
            own + QStringLiteral("/waiting"), own + QStringLiteral("/turn.json")};
}

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
    , m_nowMs(std::move(nowMs))
    , m_bar(new ui::ClassBar(m_classroom.title, program.window))
    , m_panel(new ui::PupilNamePanel(m_classroom.starters, program.window->commands(), program.window->centralWidget()))
    , m_pinPrompt(new ui::PinPrompt([record = m_classroom.pin](const QString& text) { return isPin(text, record); },
                                    program.window))
{
    program.window->setClassroom(m_classroom);
    program.window->installEventFilter(this);
    m_retryTimer.setSingleShot(true);
    connectAll();
}

ClassroomMode::~ClassroomMode() = default;

void ClassroomMode::connectAll()
{
    Document* document = m_program.document;
    connect(m_bar, &ui::ClassBar::nextRequested, this, &ClassroomMode::next);
    connect(m_bar, &ui::ClassBar::resumeRequested, this, &ClassroomMode::resume);
    connect(m_bar, &ui::ClassBar::leaveRequested, this, &ClassroomMode::leave);
    connect(m_panel, &ui::PupilNamePanel::begun, this, &ClassroomMode::prepareTurn);
    connect(m_program.recoveryStore, &RecoveryStore::offered, this, &ClassroomMode::onRecoveryOffered);
    connect(document, &Document::stepped, this, &ClassroomMode::onStep);
    connect(document, &Document::busy, m_bar, [this] { m_bar->setBusy(true); });
    connect(document, &Document::idle, m_bar, [this] { m_bar->setBusy(false); });
    connect(document, &Document::opened, this, [this] { m_isOpened = true; });
    connect(document, &Document::opened, this, &ClassroomMode::proceed, Qt::QueuedConnection);
    connect(document, &Document::idle, this, &ClassroomMode::checkOpened, Qt::QueuedConnection);
    connect(&m_clock, &QTimer::timeout, this, &ClassroomMode::tick);
    connect(&m_retryTimer, &QTimer::timeout, this, &ClassroomMode::deliver);
    document->setDiscardPrompt([this](const std::function<void()>& proceed) {
        saveThen(m_stage == Stage::Sculpting ? turnNow() : ClassTurn{newId(), {}, {}, 0}, proceed);
        return false;
    });
    m_program.window->setGuard([this] { return canClose(); });
}

void ClassroomMode::begin()
{
    m_clock.start(tickMs);
    m_background.run([archive = archive()] { archive.removeUnfinished(); });
    deliver();
    show();
    m_program.recoveryStore->findAbandoned();
}

WorkArchive ClassroomMode::archive() const
{
    return {m_classroom.folder, m_paths.outbox};
}

QString ClassroomMode::newId()
{
    return QUuid::createUuid().toString(QUuid::WithoutBraces);
}

// --- what a program before left

/// The first says what there is; the others come while the store's are taken.
void ClassroomMode::onRecoveryOffered(const RecoveryOffer& offer)
{
    m_offer = offer;
    if (m_stage == Stage::Recovering && !std::exchange(m_hasStartedRecovery, true))
        recoverNext();
}

void ClassroomMode::recoverNext()
{
    if (m_offer.id == 0)
        return askForPupil();
    const RecoveryOffer offer = m_offer;
    openThen([this, offer] { m_program.document->recover(offer.id, offer.name); },
             [this, offer] { saveRecovered(offer); });
}

/// Of one that was resumed what came before is not known any more.
void ClassroomMode::saveRecovered(const RecoveryOffer& offer)
{
    const auto note = readTurnNote(m_paths.turnNote);
    ClassTurn turn = note && note->pupil == offer.name ? *note : ClassTurn{newId(), offer.name, {}, 0};
    turn.ended = offer.changed;
    m_recordBefore.reset();
    if (note && note->pupil == offer.name && !note->isResumed)
        m_recordBefore.emplace();
    saveThen(turn, [this] { recoverNext(); });
}

// --- turns

/// Opens the first starter model at once and asks for the pupil's name, and optionally another starter, in an overlay.
void ClassroomMode::askForPupil()
{
    m_stage = Stage::Asking;
    m_turn = {};
    m_recordBefore.emplace();
    m_panel->open();
    openThen([this] { m_program.document->openStarter(m_classroom.starters.constFirst()); },
             [this] { m_program.window->beginTurn(); });
    show();
}

void ClassroomMode::prepareTurn(const QString& pupil, core::Starter starter)
{
    if (m_stage != Stage::Asking)
        return;
    openThen([this, starter] { m_program.document->openStarter(starter); },
             [this, pupil] {
                 m_program.window->beginTurn();
                 m_program.document->setName(pupil);
                 startTurn({newId(), pupil, QDateTime::currentDateTime(), 0}, TurnRecord(std::in_place));
             });
}

void ClassroomMode::startTurn(const ClassTurn& turn, const TurnRecord& before)
{
    m_stage = Stage::Sculpting;
    m_turn = turn;
    m_startMs = m_nowMs();
    m_isWarned = m_isOver = false;
    m_recordBefore = before;
    writeTurnNote(m_paths.turnNote, turn);
    m_panel->close();
    show();
}

void ClassroomMode::next()
{
    if (m_stage == Stage::Sculpting)
        saveThen(turnNow(), [this] { askForPupil(); });
}

void ClassroomMode::resume()
{
    if (!m_ended || (m_stage != Stage::Asking && m_stage != Stage::Sculpting))
        return;
    Ended ended = *m_ended;
    ended.turn.isResumed = true;
    const auto make = [archive = archive(), ended](const core::JobControl& control) {
        LoadedModel model;
        for (int attempt = 0; attempt < 2 && !model.sculptor && !control.isCancelled();
             ++attempt) // between look and reading it may be delivered
            model = ModelLoader::load(archive.locate(ended.folder, ended.turn.id) + QStringLiteral("/model.glb"), {},
                                      control);
        model.path.clear();
        model.name = ended.turn.pupil;
        return model;
    };
    openThen(
        [this, ended, make] {
            m_program.document->openMade({tr("Opening the work of %1").arg(nameOf(ended.turn)), make, {}, false});
        },
        [this, ended] {
            m_ended.reset();
            startTurn(ended.turn, ended.record);
        });
}

/// One after the other, so that what came is what was asked for.
void ClassroomMode::openThen(const std::function<void()>& open, const std::function<void()>& then)
{
    if (m_then) {
        m_then = [this, open, then] { openThen(open, then); };
        return;
    }
    m_then = then;
    open();
}

void ClassroomMode::proceed()
{
    m_isOpened = false;
    if (const auto then = std::exchange(m_then, nullptr))
        then();
}

/// What was to be opened could not be, which the window has said, or somebody stopped it: a class goes on all the same.
void ClassroomMode::checkOpened()
{
    if (!m_isOpened && !m_program.document->isBusy() && std::exchange(m_then, nullptr))
        askForPupil();
}

void ClassroomMode::onStep()
{
    if (m_stage == Stage::Sculpting)
        m_ended.reset();
    show();
}

// --- keeping the work

/// `then` only if it is safe; else the model stays open, and that is said.
void ClassroomMode::saveThen(const ClassTurn& turn, std::function<void()> then)
{
    if (m_stage == Stage::Saving)
        return;
    m_program.window->viewport()->finish();
    const auto ended = std::make_shared<Ended>(Ended{turn, {}, {}});
    const auto problem = std::make_shared<QString>();
    const auto keep = [archive = archive(), turn, before = m_recordBefore, ended,
                       problem](const Document::Present& present) {
        const QDateTime end = turn.ended.isValid() ? turn.ended : QDateTime::currentDateTime();
        ended->record = joined(before, present.steps);
        const ArchivedWork kept = archive.add({turn.id, turn.pupil, turn.begun, end, present.step, present.mesh,
                                               present.hash, present.metadata, ended->record});
        ended->folder = kept.folder;
        *problem = kept.problem;
        return kept.problem.isEmpty();
    };
    const auto done = [self = QPointer(this), ended, problem, then = std::move(then)](bool) {
        if (self)
            self->onSaved(*ended, *problem, then);
    };
    if (m_program.document->saveExternally(tr("Keeping the work of %1").arg(nameOf(turn)), keep, done))
        m_before = std::exchange(m_stage, Stage::Saving);
    else
        refuseForNow();
}

void ClassroomMode::refuseForNow()
{
    m_canLeave = false;
    Q_EMIT noticed(tr("Not yet: other work on the model is not done."));
}

void ClassroomMode::onSaved(const Ended& ended, const QString& problem, const std::function<void()>& then)
{
    m_stage = m_before;
    if (!problem.isEmpty()) {
        m_canLeave = false;
        return m_program.window->showProblem(
            tr("%1 The work of %2 stays open, and nothing of it is lost.").arg(problem, nameOf(ended.turn)));
    }
    m_ended = ended;
    m_ended->turn.ended = {};
    deliver();
    then();
}

void ClassroomMode::deliver()
{
    m_background.run(
        [archive = archive()] { return archive.deliver(); },
        [this](const Delivery& delivery) {
            if (m_ended)
                m_ended->folder = delivery.moved.value(m_ended->folder, m_ended->folder);
            m_bar->setUndelivered(
                delivery.undelivered,
                tr("%1 Until then they are in %2.").arg(delivery.problem, QDir::toNativeSeparators(m_paths.outbox)));
            const bool hasChanged = std::exchange(m_undelivered, delivery.undelivered) != delivery.undelivered;
            if (delivery.undelivered == 0)
                return;
            if (hasChanged)
                Q_EMIT noticed(tr("%1 The work is kept on this computer and goes there as soon as that is possible.")
                                   .arg(delivery.problem));
            m_retryTimer.start(retryMs);
        });
}

// --- the way out

bool ClassroomMode::canClose()
{
    if (!m_canLeave)
        leave();
    return m_canLeave;
}

void ClassroomMode::leave()
{
    m_pinPrompt->ask(tr("This ends the class. The work of the present turn is kept."), [this] {
        m_canLeave = true;
        if (m_stage != Stage::Sculpting)
            m_program.window->close();
        else
            saveThen(turnNow(), [this] {
                m_stage = Stage::Asking;
                m_program.window->close();
            });
    });
}

/// A window manager's keys may take the window off the screen: it comes back.
bool ClassroomMode::eventFilter(QObject* watched, QEvent* event)
{
    const ui::MainWindow& window = *m_program.window;
    const bool isAway = event->type() == QEvent::WindowStateChange && (!window.isFullScreen() || window.isMinimized());
    if (isAway && m_classroom.fullScreen && window.isVisible())
        QMetaObject::invokeMethod(m_program.window, &QWidget::showFullScreen, Qt::QueuedConnection);
    return QObject::eventFilter(watched, event);
}

// --- the clock

qint64 ClassroomMode::remainingMs() const
{
    return std::max<qint64>(m_classroom.turnMinutes * minuteMs - turnNow().usedMs, 0);
}

ClassTurn ClassroomMode::turnNow() const
{
    ClassTurn turn = m_turn;
    turn.usedMs += m_nowMs() - m_startMs;
    return turn;
}

void ClassroomMode::tick()
{
    if (m_stage == Stage::Sculpting && m_classroom.turnMinutes > 0) {
        const qint64 left = remainingMs();
        if (left == 0 && !std::exchange(m_isOver, true)) {
            m_isWarned = true;
            Q_EMIT noticed(tr("The time is up. Finish what you are doing; then it is the next one's turn."));
        } else if (left <= m_classroom.warningMinutes * minuteMs && !std::exchange(m_isWarned, true)) {
            Q_EMIT noticed(tr("%n minutes are left: come to an end soon.", nullptr,
                              static_cast<int>((left + minuteMs - 1) / minuteMs)));
        }
    }
    show();
}

void ClassroomMode::show()
{
    const bool isTurn = m_stage == Stage::Sculpting || (m_stage == Stage::Saving && m_before == Stage::Sculpting);
    m_bar->setPupil(isTurn ? std::optional(m_turn.pupil) : std::nullopt);
    m_bar->setResumable(m_ended && m_stage != Stage::Recovering ? std::optional(nameOf(m_ended->turn)) : std::nullopt);
    const bool hasEnd = isTurn && m_classroom.turnMinutes > 0;
    m_bar->setTime(hasEnd ? std::optional(ui::TurnTime{static_cast<int>((remainingMs() + 999) / 1000), m_isWarned})
                          : std::nullopt);
}
} // namespace app
