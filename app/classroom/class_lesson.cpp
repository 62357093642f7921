#include "app/classroom/class_lesson.h"

#include "app/document/document.h"
#include "app/lesson/lesson_cards.h"
#include "app/lesson/lesson_controller.h"
#include "app/lesson/lesson_model.h"

#include "ui/widgets/side_panel.h"
#include "ui/window/main_window.h"

namespace app
{
ClassLesson::ClassLesson(const QString& lesson, ui::MainWindow* window, Document* document)
    : m_window(window)
    , m_document(document)
{
    if (!lesson.isEmpty())
        m_place = {tryToReadLesson(lesson, readLessonOfClass).lesson, toPath(lesson)};
}

ui::LessonCard ClassLesson::card() const
{
    return cardOf(QString(), *m_place.lesson);
}

void ClassLesson::open() const
{
    const auto make = [model = LessonModel{m_place.lesson, m_place.path}](const core::JobControl& control) {
        return model.load(control);
    };
    m_document->opener().openMade({tr("Opening %1").arg(inOurLanguage(m_place.lesson->title)), make});
}

void ClassLesson::resume(const LessonPlace& place) const
{
    m_window->findChild<ui::SidePanel*>(QStringLiteral("lessonPanel"))->bringForward();
    m_document->findChild<LessonController*>()->start(place);
}

std::optional<LessonPlace> ClassLesson::place() const
{
    return m_document->findChild<LessonController*>()->place();
}

std::optional<LessonPlace> ClassLesson::find(const LessonPlace& noted) const
{
    if (!isThere() || noted.path != m_place.path || noted.step >= m_place.lesson->steps.size())
        return std::nullopt;
    return LessonPlace{m_place.lesson, m_place.path, noted.step, noted.isTeachers};
}

std::optional<LessonPlace> ClassLesson::stop() const
{
    return m_document->findChild<LessonController*>()->stop();
}
} // namespace app
