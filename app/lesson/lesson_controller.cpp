#include "app/lesson/lesson_controller.h"

#include "app/document/document.h"
#include "app/lesson/lesson_library.h"
#include "app/lesson/lesson_messages.h"
#include "app/lesson/lesson_model.h"

#include "ui/help/start_page.h"
#include "ui/viewport/viewport.h"
#include "ui/widgets/file_dialogs.h"
#include "ui/window/main_window.h"

#include <QAction>

namespace app
{
namespace
{
constexpr int tickMs = 16;
constexpr quint64 maxSamplesBehind = 3; ///< samples that the mesh thread may be behind: so none is ever dropped
constexpr double maxTick = 0.1;         ///< s: a window that was held up does not make up for it

QImage pictureOf(const core::Lesson& lesson, const std::string& name)
{
    const auto found = lesson.files.find(name);
    return found == lesson.files.end() ? QImage()
                                       : QImage::fromData(reinterpret_cast<const uchar*>(found->second.data()),
                                                          static_cast<int>(found->second.size()));
}

ui::LessonPage pageOf(const core::Lesson& lesson, std::size_t index)
{
    const core::LessonStep& step = lesson.steps[index];
    return {inOurLanguage(lesson.title),     inOurLanguage(step.title),         inOurLanguage(step.text),
            pictureOf(lesson, step.picture), static_cast<int>(index),           static_cast<int>(lesson.steps.size()),
            !step.strokes.empty(),           step.checkpoint.target.has_value()};
}

/// Of the lessons that are inside of the program.
QList<ui::LessonCard> cards()
{
    QList<ui::LessonCard> all;
    for (const QString& name : bundledLessons()) {
        const std::shared_ptr<const core::Lesson> lesson = tryToReadLesson(name).lesson;
        if (lesson)
            all.append({name, inOurLanguage(lesson->title), inOurLanguage(lesson->summary),
                        pictureOf(*lesson, lesson->steps.back().picture)});
    }
    return all;
}
} // namespace

LessonController::LessonController(ui::MainWindow& window, Document& document, SculptWorker& worker)
    : QObject(&document)
    , m_window(&window)
    , m_panel(window.findChild<ui::LessonPanel*>())
    , m_document(&document)
    , m_worker(&worker)
    , m_checker(new LessonChecker(&document, &worker))
{
    using ui::LessonPanel;
    m_timer.setInterval(tickMs);
    m_timer.setTimerType(Qt::PreciseTimer);
    const QList<ui::LessonCard> lessons = cards();
    m_panel->setLessons(lessons);
    addToStartPage(lessons);
    connect(&m_timer, &QTimer::timeout, this, &LessonController::tick);
    connect(m_panel, &LessonPanel::lessonChosen, this, &LessonController::read);
    connect(m_panel, &LessonPanel::fileRequested, this,
            [this] { ui::askForLesson(m_window, [this](const QString& path) { read(lessonOrItsFolder(path)); }); });
    connect(m_panel, &LessonPanel::stepRequested, this, &LessonController::goTo);
    connect(m_panel, &LessonPanel::playRequested, this, &LessonController::playOrPause);
    connect(m_panel, &LessonPanel::singleStrokeRequested, this, &LessonController::playOne);
    connect(m_panel, &LessonPanel::tryRequested, this, &LessonController::tryIt);
    connect(m_panel, &LessonPanel::closed, this, &LessonController::leave);
    connect(m_panel, &LessonPanel::differenceRequested, this, &LessonController::shade);
    connect(m_panel, &LessonPanel::speedChosen, this, [this](double speed) {
        m_speed = speed;
        if (m_player)
            m_player->setSpeed(speed);
    });
    connect(m_window->viewport(), &ui::Viewport::strokeBegan, this, &LessonController::interrupt);
    connect(m_worker, &SculptWorker::strokeRefused, this, &LessonController::onStrokeRefused);
    connect(m_document, &Document::opened, this, &LessonController::begin);
    connect(m_checker, &LessonChecker::finished, this, &LessonController::showVerdict);
    connect(m_checker, &IdleAnalysis::outdated, this, [this] { showVerdict({}, {}); });
}

void LessonController::addToStartPage(const QList<ui::LessonCard>& lessons)
{
    auto* start = m_window->findChild<ui::StartPage*>();
    start->setLessons(lessons);
    connect(start, &ui::StartPage::lessonChosen, this, [this](const QString& name) {
        m_window->action(QStringLiteral("help.lessons"))->trigger();
        read(name);
    });
}

void LessonController::read(const QString& pathOrName)
{
    m_background.run([pathOrName] { return tryToReadLesson(pathOrName); },
                     [this, path = toPath(pathOrName)](const ReadLesson& read) {
                         if (!m_window)
                             return;
                         if (read.lesson)
                             openLesson(read.lesson, path);
                         else
                             m_window->showProblem(read.problem);
                     });
}

void LessonController::openLesson(std::shared_ptr<const core::Lesson> lesson, const std::filesystem::path& path)
{
    m_opening = lesson;
    m_openingPath = path;
    const auto make = [model = LessonModel{lesson, path}](const core::JobControl& control) {
        return model.load(control);
    };
    m_document->openMade({tr("Opening %1").arg(inOurLanguage(lesson->title)), make, lesson});
}

/// Another model is here: the lesson's start, or the end of the lesson.
void LessonController::begin()
{
    leave();
    const std::shared_ptr<const core::Lesson> opening = std::exchange(m_opening, nullptr);
    if (!opening || m_document->mark() != opening)
        return;
    m_lesson = opening;
    m_path = m_openingPath;
    m_player.emplace(m_lesson);
    m_player->setSpeed(m_speed);
    enter(0);
    m_window->viewport()->turnTo(ui::OrbitCamera::Side::Front);
}

void LessonController::leave()
{
    interrupt();
    if (m_player) {
        m_window->viewport()->setShades(nullptr);
        m_window->brush()->offerTools({});
    }
    m_player.reset();
    m_lesson = nullptr;
    m_starts.clear();
    m_checker->setPosition({});
    m_panel->showLessons();
}

/// From the model as it is.
void LessonController::enter(std::size_t step)
{
    m_player->setStep(step);
    m_starts.push_back(m_document->undoStack().index());
    show();
}

void LessonController::show()
{
    const std::size_t step = m_player->stepIndex();
    m_panel->showPage(pageOf(*m_lesson, step));
    m_window->viewport()->frame();
    const std::vector<core::Tool>& tools = m_lesson->steps[step].tools;
    m_window->brush()->offerTools(QList<core::Tool>(tools.begin(), tools.end()));
    m_checker->setPosition({m_lesson, m_path, step});
}

/// Forward with the model as it is, back to the model as it was.
void LessonController::goTo(int step)
{
    interrupt();
    const auto target = static_cast<std::size_t>(step);
    if (target < m_player->stepIndex()) {
        m_starts.resize(target + 1);
        m_document->goTo(m_starts.back());
        m_player->setStep(target);
        return show();
    }
    m_document->enqueue([this, target] {
        if (m_player && target == m_player->stepIndex() + 1)
            enter(target);
    });
}

/// From the step's start, unless the teacher is in the middle of it.
void LessonController::beTaught()
{
    if (m_isTaught)
        return;
    tryIt();
    m_isTaught = true;
}

void LessonController::playOrPause(bool on)
{
    if (on)
        beTaught();
    on ? m_player->play() : m_player->pause();
    setPlaying(on);
}

void LessonController::playOne()
{
    beTaught();
    m_player->playOne();
    setPlaying(true);
}

void LessonController::setPlaying(bool isPlaying)
{
    m_panel->setPlaying(isPlaying);
    m_sinceTick.start();
    isPlaying ? m_timer.start() : m_timer.stop();
}

/// What was done in the step is taken back.
void LessonController::tryIt()
{
    interrupt();
    m_document->goTo(m_starts.back());
    m_player->setStep(m_player->stepIndex());
    m_panel->setProgress(0);
}

/// The teacher lets go.
void LessonController::interrupt()
{
    endStroke();
    m_timer.stop();
    m_isTaught = false;
    if (!m_player)
        return;
    m_player->pause();
    m_panel->setPlaying(false);
    showGhost({});
}

/// Two strokes at once, the teacher's and one in the headset: whichever was refused, it is the pupil's turn.
void LessonController::onStrokeRefused()
{
    if (m_timer.isActive())
        interrupt();
}

void LessonController::endStroke()
{
    if (std::exchange(m_isStrokeOpen, false))
        m_document->endStroke();
}

/// The mesh thread has that many samples of the teacher's still before it.
bool LessonController::isBehind() const
{
    return m_isStrokeOpen && m_isCounted && m_posted > m_worker->stats().samples - m_consumedBefore + maxSamplesBehind;
}

void LessonController::tick()
{
    const double seconds = std::min(static_cast<double>(m_sinceTick.restart()) / 1000, maxTick);
    if (m_document->isBusy() || isBehind() || (!m_isStrokeOpen && !m_document->isSettled()))
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

void LessonController::run(const core::LessonCue& cue)
{
    if (const auto* const stroke = std::get_if<core::StrokeBegins>(&cue)) {
        m_isStrokeOpen = true;
        m_isCounted = !stroke->settings.add;
        m_posted = 0;
        m_consumedBefore = m_worker->stats().samples;
        m_document->beginStroke(stroke->settings);
    } else if (const auto* const sample = std::get_if<core::StrokeSample>(&cue)) {
        ++m_posted;
        m_document->addSample(*sample);
    } else if (const auto* const command = std::get_if<core::ModelCommand>(&cue)) {
        m_document->apply(*command);
    } else {
        endStroke();
    }
}

/// Where a ray meets the model is asked of the mesh thread, one question at a time.
void LessonController::placeGhost()
{
    const std::optional<core::GhostBrush> ghost = m_player->ghost();
    if (!ghost || !ghost->direction)
        return showGhost(ghost ? std::optional(core::Sphere{ghost->position, ghost->radius}) : std::nullopt);
    if (std::exchange(m_isGhostAsked, true))
        return;
    m_worker->post([this, ghost](core::Sculptor& sculptor) {
        const auto hit = sculptor.hit({ghost->position, *ghost->direction});
        const auto answer = [this, hit, radius = ghost->radius] {
            m_isGhostAsked = false;
            if (m_timer.isActive())
                showGhost(hit ? std::optional(core::Sphere{hit->position, radius}) : std::nullopt);
        };
        QMetaObject::invokeMethod(this, answer, Qt::QueuedConnection);
    });
}

void LessonController::showGhost(const std::optional<core::Sphere>& ghost)
{
    if (m_window)
        m_window->viewport()->showTeacher(ghost);
}

void LessonController::showVerdict(const core::CheckpointVerdict& verdict,
                                   const std::shared_ptr<const core::Footprint>& shades)
{
    if (!m_panel || !m_window)
        return;
    QList<ui::LessonMark> marks;
    if (m_player && !m_player->step().strokes.empty() && !(verdict.facts.empty() && !verdict.target))
        marks.append({m_document->undoStack().index() > m_starts.back(), tr("something sculpted in this step")});
    for (const core::FactVerdict& fact : verdict.facts)
        marks.append({fact.holds, tr("%1 (%2)", "what is asked; what is")
                                      .arg(LessonMessages::asked(fact.asked), LessonMessages::found(fact))});
    if (verdict.target)
        marks.append({verdict.target->holds,
                      tr("%1 (%2)", "what is asked; what is")
                          .arg(LessonMessages::asked(core::CheckpointTarget{{}, verdict.target->tolerance}),
                               LessonMessages::found(*verdict.target))});
    if (m_player)
        m_panel->setMarks(marks);
    m_shades = shades;
    shade();
}

void LessonController::shade()
{
    if (m_window && m_player)
        m_window->viewport()->setShades(m_panel->wantsDifference() ? m_shades : nullptr);
}
} // namespace app
