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

LessonController::LessonController(ui::MainWindow& window, Document& document)
    : QObject(&document)
    , m_window(&window)
    , m_panel(window.findChild<ui::LessonPanel*>())
    , m_document(&document)
    , m_checker(new LessonChecker(&document, &document.worker()))
    , m_teacher(window, document)
{
    using ui::LessonPanel;
    const QList<ui::LessonCard> lessons = cards();
    m_panel->setLessons(lessons);
    addToStartPage(lessons);
    connect(m_panel, &LessonPanel::lessonChosen, this, &LessonController::read);
    connect(m_panel, &LessonPanel::fileRequested, this,
            [this] { ui::askForLesson(m_window, [this](const QString& path) { read(lessonOrItsFolder(path)); }); });
    connect(m_panel, &LessonPanel::stepRequested, this, &LessonController::goTo);
    connect(m_panel, &LessonPanel::closed, this, &LessonController::leave);
    connect(m_panel, &LessonPanel::differenceRequested, this, &LessonController::shade);
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
    m_document->opener().openMade({tr("Opening %1").arg(inOurLanguage(lesson->title)), make, lesson});
}

/// Another model is here: the lesson's start, or the end of the lesson.
void LessonController::begin()
{
    leave();
    const std::shared_ptr<const core::Lesson> opening = std::exchange(m_opening, nullptr);
    if (!opening || m_document->opener().mark() != opening)
        return;
    m_lesson = opening;
    m_path = m_openingPath;
    m_teacher.setLesson(m_lesson);
    enter(0);
    m_window->viewport()->navigation()->turnTo(ui::OrbitCamera::Side::Front);
}

void LessonController::leave()
{
    m_teacher.interrupt();
    if (m_teacher.hasLesson()) {
        m_window->viewport()->setShades(nullptr);
        m_window->brush()->offerTools({});
    }
    m_teacher.setLesson(nullptr);
    m_lesson = nullptr;
    m_checker->setPosition({});
    m_panel->showLessons();
}

void LessonController::enter(std::size_t step)
{
    m_teacher.enter(step);
    show();
}

void LessonController::show()
{
    const std::size_t step = m_teacher.stepIndex();
    m_panel->showPage(pageOf(*m_lesson, step));
    m_window->viewport()->navigation()->frame();
    const std::vector<core::Tool>& tools = m_lesson->steps[step].tools;
    m_window->brush()->offerTools(QList<core::Tool>(tools.begin(), tools.end()));
    m_checker->setPosition({m_lesson, m_path, step});
}

/// Forward with the model as it is, back to the model as it was.
void LessonController::goTo(int step)
{
    m_teacher.interrupt();
    const auto target = static_cast<std::size_t>(step);
    if (target < m_teacher.stepIndex()) {
        m_teacher.goBack(target);
        return show();
    }
    m_document->queue().enqueue([this, target] {
        if (m_teacher.hasLesson() && target == m_teacher.stepIndex() + 1)
            enter(target);
    });
}

void LessonController::showVerdict(const core::CheckpointVerdict& verdict,
                                   const std::shared_ptr<const core::Footprint>& shades)
{
    if (!m_panel || !m_window)
        return;
    QList<ui::LessonMark> marks;
    if (m_teacher.hasLesson() && !m_teacher.step().strokes.empty() && !(verdict.facts.empty() && !verdict.target))
        marks.append({m_teacher.hasChanges(), tr("something sculpted in this step")});
    for (const core::FactVerdict& fact : verdict.facts)
        marks.append({fact.holds, tr("%1 (%2)", "what is asked; what is")
                                      .arg(LessonMessages::asked(fact.asked), LessonMessages::found(fact))});
    if (verdict.target)
        marks.append({verdict.target->holds,
                      tr("%1 (%2)", "what is asked; what is")
                          .arg(LessonMessages::asked(core::CheckpointTarget{{}, verdict.target->tolerance}),
                               LessonMessages::found(*verdict.target))});
    if (m_teacher.hasLesson())
        m_panel->setMarks(marks);
    m_shades = shades;
    shade();
}

void LessonController::shade()
{
    if (m_window && m_teacher.hasLesson())
        m_window->viewport()->setShades(m_panel->wantsDifference() ? m_shades : nullptr);
}
} // namespace app
