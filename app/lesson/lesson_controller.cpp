#include "app/lesson/lesson_controller.h"

#include "app/document/document.h"
#include "app/lesson/lesson_cards.h"
#include "app/lesson/lesson_messages.h"
#include "app/lesson/lesson_model.h"

#include "ui/help/start_page.h"
#include "ui/viewport/viewport.h"
#include "ui/widgets/file_dialogs.h"
#include "ui/window/main_window.h"

#include <QAction>

#include <algorithm>

namespace app
{
namespace
{
/// Returns the brushes of the step as text: "Pull 42 mm, Smooth 26 mm".
QString brushText(const core::LessonStep& step)
{
    QStringList brushes;
    for (const core::LessonBrush& brush : core::brushesOf(step))
        brushes << LessonMessages::brush(brush);
    return brushes.join(QStringLiteral(", "));
}

ui::LessonPage pageOf(const core::Lesson& lesson, std::size_t index)
{
    const core::LessonStep& step = lesson.steps[index];
    return {inOurLanguage(lesson.title),
            inOurLanguage(step.title),
            inOurLanguage(step.text),
            pictureOf(lesson, step.picture),
            static_cast<int>(index),
            static_cast<int>(lesson.steps.size()),
            !step.strokes.empty(),
            step.checkpoint.target.has_value(),
            brushText(step)};
}

/// Returns the goals of a step, none of them met, before anything is measured.
QList<ui::LessonMark> askedMarks(const core::LessonStep& step)
{
    QList<ui::LessonMark> marks;
    if (step.checkpoint.asksNothing())
        return marks;
    if (!step.strokes.empty())
        marks.append({false, LessonMessages::sculpted()});
    for (const core::FactBounds& bounds : step.checkpoint.facts)
        marks.append({false, LessonMessages::asked(bounds)});
    if (step.checkpoint.target)
        marks.append({false, LessonMessages::asked(*step.checkpoint.target)});
    return marks;
}
} // namespace

LessonController::LessonController(ui::MainWindow& window, Document& document)
    : QObject(&document)
    , m_window(&window)
    , m_panel(window.findChild<ui::LessonPanel*>())
    , m_document(&document)
    , m_checker(new LessonChecker(&document, &document.worker()))
    , m_teacher(window, document)
    , m_brushes(window.brush())
    , m_handout(&window)
{
    using ui::LessonPanel;
    const QList<ui::LessonCard> lessons = bundledLessonCards();
    m_panel->setLessons(lessons);
    addToStartPage(lessons);
    connect(m_panel, &LessonPanel::lessonChosen, this, &LessonController::read);
    connect(m_panel, &LessonPanel::fileRequested, this,
            [this] { ui::askForLesson(m_window, [this](const QString& path) { read(lessonOrItsFolder(path)); }); });
    connect(m_panel, &LessonPanel::stepRequested, this, &LessonController::goTo);
    connect(m_panel, &LessonPanel::teachersModelRequested, this, [this] {
        m_teacher.startFromOwn([this] {
            if (m_teacher.hasLesson())
                show();
        });
    });
    connect(m_panel, &LessonPanel::closed, this, &LessonController::leave);
    connect(m_panel, &LessonPanel::differenceRequested, this, &LessonController::shade);
    connect(m_panel, &LessonPanel::handoutRequested, this, [this] { m_handout.ask(m_lesson); });
    connect(m_document, &Document::opened, this, &LessonController::begin);
    connect(m_checker, &LessonChecker::finished, this, &LessonController::showVerdict);
    connect(m_checker, &IdleAnalysis::outdated, this, &LessonController::keepMarks);
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
    m_document->opener().openMade({tr("Opening %1").arg(inOurLanguage(lesson->title)), make, lesson});
}

/// Called when a model was opened: begins the lesson if this is its start, otherwise ends the open lesson.
void LessonController::begin()
{
    leave();
    const std::shared_ptr<const core::Lesson> opening = std::exchange(m_opening, nullptr);
    if (!opening || m_document->opener().mark() != opening)
        return;
    start({opening, m_openingPath});
}

void LessonController::start(const LessonPlace& place)
{
    leave();
    m_lesson = place.lesson;
    m_path = place.path;
    m_teacher.setLesson(m_lesson);
    m_window->viewport()->navigation()->turnTo(ui::OrbitCamera::Side::Front);
    // enters all earlier steps, so that Back can return to each of them
    for (std::size_t step = 0; step <= place.step; ++step)
        m_teacher.enter(step);
    show();
}

std::optional<LessonPlace> LessonController::stop()
{
    if (m_lesson)
        m_teacher.interrupt();
    return place();
}

std::optional<LessonPlace> LessonController::place() const
{
    if (!m_lesson)
        return std::nullopt;
    return LessonPlace{m_lesson, m_path, m_teacher.stepIndex(), m_teacher.changedBy() == LessonTeacher::Hand::Teachers};
}

void LessonController::leave()
{
    m_teacher.interrupt();
    if (m_teacher.hasLesson()) {
        m_window->viewport()->setShades(nullptr);
        m_brushes.giveBack();
    }
    m_teacher.setLesson(nullptr);
    m_lesson = nullptr;
    m_progress.clear();
    m_isAtEnd = false;
    m_checker->setPosition({});
    m_panel->showLessons();
}

void LessonController::show()
{
    const std::size_t step = m_teacher.stepIndex();
    m_isAtEnd = false;
    m_panel->showPage(pageOf(*m_lesson, step), askedMarks(m_lesson->steps[step]));
    m_brushes.take(m_lesson->steps[step]);
    m_isMet.reset();
    m_checker->setPosition({m_lesson, m_path, step});
}

/// Shows the end page and offers all tools. A measurement in progress still counts; later changes do not.
void LessonController::showEnd()
{
    m_isAtEnd = true;
    if (m_isMet)
        m_checker->setPosition({});
    m_brushes.giveBack();
    const bool canExport = m_window && m_window->action(QStringLiteral("file.exportAs"))->isVisible();
    m_panel->showPage(m_progress.endOf(*m_lesson, canExport), m_progress.marksOf(*m_lesson));
}

/// Moves to a step. Going forward keeps the model, but first completes a demonstration in progress. Going back restores
/// the model as it was when that step was entered. From the end page, returns to the last step.
void LessonController::goTo(int step)
{
    const auto target = static_cast<std::size_t>(step);
    if (m_isAtEnd)
        return show();
    if (target < m_teacher.stepIndex()) {
        m_teacher.interrupt();
        m_teacher.goBack(target);
        return show();
    }
    m_teacher.finish([this, target] { m_document->queue().enqueue([this, target] { goOn(target); }); });
}

void LessonController::goOn(std::size_t step)
{
    if (!m_teacher.hasLesson() || step != m_teacher.stepIndex() + 1)
        return;
    const bool isUnmet = !m_isMet.value_or(true) && m_teacher.changedBy() != LessonTeacher::Hand::Teachers;
    m_teacher.interrupt();
    if (step == m_lesson->steps.size())
        return showEnd();
    m_teacher.enter(step);
    show();
    if (isUnmet && m_window)
        m_window->showNotice(
            tr("Step %1 is not done yet. You can go back, or start from the teacher's model.").arg(step));
}

void LessonController::showVerdict(const core::CheckpointVerdict& verdict,
                                   const std::shared_ptr<const core::Footprint>& shades)
{
    if (!m_panel || !m_window)
        return;
    if (m_teacher.hasLesson()) {
        const QList<ui::LessonMark> marks = marksOf(verdict);
        m_progress.set(m_teacher.stepIndex(), static_cast<int>(std::ranges::count_if(marks, &ui::LessonMark::holds)),
                       marks.isEmpty() ? 0 : static_cast<int>(askedMarks(m_teacher.step()).size()));
        m_isAtEnd ? showEnd() : m_panel->setMarks(marks);
    }
    m_shades = shades;
    shade();
}

/// Shows the previous marks as out of date until the changed model is measured.
void LessonController::keepMarks()
{
    m_isMet.reset();
    if (m_panel && m_panel->shown() && !m_isAtEnd)
        m_panel->setMarks(m_panel->shown()->marks, false);
    m_shades = nullptr;
    shade();
}

/// Returns the marks of the step. No goal counts as met in a model made by the demonstration.
QList<ui::LessonMark> LessonController::marksOf(const core::CheckpointVerdict& verdict)
{
    m_isMet.reset();
    if (verdict.facts.empty() && !verdict.target)
        return {};
    if (m_teacher.changedBy() == LessonTeacher::Hand::Teachers)
        return {{false, tr("This is the teacher's model. Press Try It and make your own.")}};
    QList<ui::LessonMark> marks;
    if (!m_teacher.step().strokes.empty())
        marks.append({m_teacher.changedBy() == LessonTeacher::Hand::Pupils, LessonMessages::sculpted()});
    for (const core::FactVerdict& fact : verdict.facts)
        marks.append({fact.holds, LessonMessages::goal(fact)});
    if (verdict.target)
        marks.append({verdict.target->holds, LessonMessages::goal(*verdict.target)});
    m_isMet = std::ranges::all_of(marks, &ui::LessonMark::holds);
    return marks;
}

void LessonController::shade()
{
    if (m_window && m_teacher.hasLesson())
        m_window->viewport()->setShades(m_panel->wantsDifference() ? m_shades : nullptr);
}
} // namespace app
