#include "app/lesson/lesson_teacher.h"

#include "app/document/document.h"
#include "app/worker/sculpt_worker.h"

#include "core/sculpt/sculptor.h"
#include "ui/lesson/lesson_panel.h"
#include "ui/viewport/viewport.h"
#include "ui/window/main_window.h"

#include <algorithm>
#include <utility>

namespace app
{
namespace
{
constexpr int tickMs = 16;
constexpr quint64 maxSamplesBehind = 3; ///< samples that may wait for the mesh thread, few enough that none is dropped
constexpr int advancesPerTick = 20;
constexpr double maxTick = 0.1; ///< longest time step, seconds; after a delay the demonstration does not catch up
} // namespace

LessonTeacher::LessonTeacher(ui::MainWindow& window, Document& document)
    : m_window(&window)
    , m_panel(window.findChild<ui::LessonPanel*>())
    , m_document(&document)
    , m_camera(window.viewport())
{
    using ui::LessonPanel;
    m_timer.setInterval(tickMs);
    m_timer.setTimerType(Qt::PreciseTimer);
    connect(&m_timer, &QTimer::timeout, this, &LessonTeacher::tick);
    connect(m_panel, &LessonPanel::playRequested, this, &LessonTeacher::play);
    connect(m_panel, &LessonPanel::singleStrokeRequested, this, &LessonTeacher::playOne);
    connect(m_panel, &LessonPanel::tryRequested, this, &LessonTeacher::tryIt);
    connect(m_panel, &LessonPanel::speedChosen, this, &LessonTeacher::setSpeed);
    connect(&document.history().stack(), &QUndoStack::indexChanged, this, &LessonTeacher::onIndexChanged);
    connect(&document, &Document::stepped, this, [this] { // a new step that is not a redo
        if (m_isUndone && !m_starts.empty() && m_document->history().stack().index() == m_starts.back() + 1)
            m_isUndone = m_hasShown = false;
    });
    connect(window.viewport()->input(), &ui::PointerInput::strokeBegan, this, &LessonTeacher::interrupt);
    connect(&document.worker().strokes(), &StrokeGate::refused, this, [this] {
        if (m_timer.isActive()) // demonstration and pupil began a stroke at once: the pupil takes precedence
            interrupt();
    });
}

void LessonTeacher::setLesson(std::shared_ptr<const core::Lesson> lesson)
{
    m_player.reset();
    m_starts.clear();
    if (!lesson)
        return;
    m_player.emplace(std::move(lesson));
    m_player->setSpeed(m_speed);
}

LessonTeacher::Hand LessonTeacher::changedBy() const
{
    if (m_hasShown)
        return Hand::Teachers;
    return m_document->history().stack().index() > m_starts.back() ? Hand::Pupils : Hand::Nobodys;
}

/// Updates whether the model contains strokes of the demonstration: not after undo has reached the start of the step,
/// but again after a redo.
void LessonTeacher::onIndexChanged(int index)
{
    if (!hasLesson() || m_starts.empty() || m_timer.isActive())
        return;
    if (index > m_starts.back()) {
        m_hasShown = m_hasShown || m_isUndone;
        return;
    }
    m_isUndone = m_isUndone || m_hasShown;
    m_hasShown = m_isTaught = false;
}

void LessonTeacher::enter(std::size_t step)
{
    m_player->setStep(step);
    m_starts.push_back(m_document->history().stack().index());
    m_hasShown = m_isUndone = false;
    m_camera.show(this->step());
}

void LessonTeacher::goBack(std::size_t step)
{
    m_starts.resize(step + 1);
    m_document->history().goTo(m_starts.back());
    m_player->setStep(step);
    m_hasShown = m_isUndone = false;
    m_camera.show(this->step());
}

void LessonTeacher::setSpeed(double speed)
{
    m_speed = speed;
    if (m_player)
        m_player->setSpeed(speed);
}

/// Undoes the step and starts its demonstration, unless that is already in progress.
void LessonTeacher::startStep()
{
    if (m_isTaught)
        return;
    tryIt();
    m_isTaught = m_hasShown = true;
    m_isUndone = false;
    m_camera.rest();
    m_camera.show(step());
}

void LessonTeacher::play(bool on)
{
    if (on)
        startStep();
    on ? m_player->play() : m_player->pause();
    setPlaying(on);
}

void LessonTeacher::playOne()
{
    startStep();
    m_player->playOne();
    setPlaying(true);
}

/// Starts or pauses the demonstration at normal speed; ends playing at full speed.
void LessonTeacher::setPlaying(bool isPlaying)
{
    m_afterHurry = nullptr;
    m_timer.setInterval(tickMs);
    m_panel->setPlaying(isPlaying);
    m_sinceTick.start();
    isPlaying ? m_timer.start() : m_timer.stop();
}

void LessonTeacher::tryIt()
{
    interrupt();
    m_document->history().goTo(m_starts.back());
    m_player->setStep(m_player->stepIndex());
    m_isUndone = m_isUndone || m_hasShown;
    m_hasShown = false;
    m_panel->setProgress(0);
}

void LessonTeacher::interrupt()
{
    endStroke();
    m_timer.stop();
    m_timer.setInterval(tickMs);
    m_afterHurry = nullptr;
    m_isTaught = false;
    if (!m_player)
        return;
    m_player->pause();
    if (const auto entered = std::exchange(m_entered, std::nullopt)) // the teacher's model for the step is incomplete
        m_player->setStep(*entered);
    m_panel->setPlaying(false);
    showGhost({});
}

void LessonTeacher::endStroke()
{
    if (std::exchange(m_isStrokeOpen, false))
        m_document->strokes().endStroke();
}

/// Returns whether the mesh thread still has too many unconsumed samples of the demonstration.
bool LessonTeacher::isBehind() const
{
    return m_isStrokeOpen && m_posted > m_document->worker().stats().samples - m_consumedBefore + maxSamplesBehind;
}

void LessonTeacher::finish(std::function<void()> done)
{
    if (m_afterHurry)
        m_afterHurry = [first = std::move(m_afterHurry), then = std::move(done)] {
            first();
            then();
        };
    else if (m_isTaught && !m_player->isAtEnd())
        hurry(std::move(done));
    else
        done();
}

/// Keeps the pupil's work in the history, so that it can be restored by undo.
void LessonTeacher::startFromOwn(std::function<void()> done)
{
    interrupt();
    m_entered = m_player->stepIndex();
    m_hasShown = true;
    m_isUndone = false;
    m_document->queue().enqueue([this] {
        if (m_entered && m_document->history().stack().index() > 0) // at 0 the model already is the lesson's start
            m_document->changer().apply(core::Reset{});
    });
    m_player->setStep(0);
    hurry(std::move(done));
}

void LessonTeacher::hurry(std::function<void()> done)
{
    m_afterHurry = std::move(done);
    m_player->play();
    m_timer.setInterval(0);
    m_timer.start();
}

/// Advances as fast as the mesh thread consumes samples, a few at a time.
void LessonTeacher::tickInHurry()
{
    const auto isHeld = [this] {
        return m_document->job().isBusy() || isBehind() || (!m_isStrokeOpen && !m_document->queue().isSettled());
    };
    for (int i = 0; i < advancesPerTick && !isHeld(); ++i) {
        if (m_player->stepIndex() == m_entered || !m_player->isPlaying())
            return goOnInHurry();
        for (const core::LessonCue& cue : m_player->advance(core::LessonPlayer::samplePause / m_player->speed()))
            run(cue);
    }
}

/// Continues with the next step to be played, or calls m_afterHurry at the end.
void LessonTeacher::goOnInHurry()
{
    if (m_entered && m_player->stepIndex() != m_entered) {
        m_player->setStep(m_player->stepIndex() + 1);
        return m_player->play();
    }
    if (m_entered) {
        m_starts.back() = m_document->history().stack().index();
        m_hasShown = m_isUndone = false;
        m_camera.show(step());
    }
    const std::function<void()> done = std::move(m_afterHurry);
    interrupt();
    done();
}

void LessonTeacher::tick()
{
    if (m_afterHurry)
        return tickInHurry();
    const double seconds = std::min(static_cast<double>(m_sinceTick.restart()) / 1000, maxTick);
    if (m_document->job().isBusy() || isBehind() || (!m_isStrokeOpen && !m_document->queue().isSettled()))
        return;
    for (const core::LessonCue& cue : m_player->advance(seconds))
        run(cue);
    m_panel->setProgress(m_player->duration() > 0 ? m_player->time() / m_player->duration() : 1);
    if (m_player->isPlaying())
        placeGhost();
    else if (m_player->isAtEnd())
        interrupt();
    else
        setPlaying(false);
}

void LessonTeacher::run(const core::LessonCue& cue)
{
    if (const auto* const stroke = std::get_if<core::StrokeBegins>(&cue)) {
        m_isStrokeOpen = true;
        m_posted = 0;
        m_consumedBefore = m_document->worker().stats().samples;
        m_document->parts().activate(stroke->settings.part);
        m_document->strokes().beginStroke(stroke->settings);
    } else if (const auto* const sample = std::get_if<core::StrokeSample>(&cue)) {
        ++m_posted;
        m_document->strokes().addSample(*sample);
    } else if (const auto* const command = std::get_if<core::FileCommand>(&cue)) {
        m_document->changer().applyTo(command->part, command->command);
    } else {
        endStroke();
    }
}

/// Shows the demonstration's brush. Asks the mesh thread where its ray meets the model, one question at a time.
void LessonTeacher::placeGhost()
{
    const std::optional<core::GhostBrush> ghost = m_player->ghost();
    if (!ghost || !ghost->direction)
        return showGhost(ghost, ghost ? ghost->position : core::Vec3::Zero());
    if (std::exchange(m_isGhostAsked, true))
        return;
    m_document->worker().post([this, ghost](core::Sculptor& sculptor) {
        const auto hit = sculptor.hit({ghost->position, *ghost->direction});
        const auto answer = [this, hit, ghost] {
            m_isGhostAsked = false;
            if (m_timer.isActive())
                hit ? showGhost(ghost, hit->position) : showGhost({});
        };
        QMetaObject::invokeMethod(this, answer, Qt::QueuedConnection);
    });
}

void LessonTeacher::showGhost(const std::optional<core::GhostBrush>& ghost, const core::Vec3& at)
{
    if (!m_window)
        return;
    const auto shown = ghost ? std::optional(core::Sphere{at, ghost->radius}) : std::nullopt;
    m_window->viewport()->showTeacher(shown);
    if (shown)
        m_camera.follow(*ghost, *shown);
}
} // namespace app
