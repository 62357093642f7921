#pragma once

#include "app/lesson/lesson_place.h"

#include "ui/lesson/lesson_panel.h"

#include <QCoreApplication>

#include <optional>

namespace ui
{
class MainWindow;
}

namespace app
{
class Document;

/// The lesson that the turns of a class may begin with. Thread: gui.
class ClassLesson
{
    Q_DECLARE_TR_FUNCTIONS(app::ClassLesson)

public:
    /// `lesson`: as ui::Classroom has it. None is owned; all must outlive this.
    ClassLesson(const QString& lesson, ui::MainWindow* window, Document* document);

    bool isThere() const { return m_place.lesson != nullptr; }
    ui::LessonCard card() const;
    /// Opens the model that the lesson begins with.
    void open() const;
    /// Begins the lesson with the model that is open, with its panel beside it.
    void begin() const { resume(m_place); }
    void resume(const LessonPlace& place) const;
    /// Returns where the lesson is; nothing if none is open.
    std::optional<LessonPlace> place() const;
    /// Returns the place that a note tells of; nothing if the class has another lesson by now.
    std::optional<LessonPlace> find(const LessonPlace& noted) const;
    /// Stops the teacher. Returns where the lesson is; nothing if none is open.
    std::optional<LessonPlace> stop() const;

private:
    ui::MainWindow* m_window;
    Document* m_document;
    LessonPlace m_place; ///< of the first step; no lesson in it: the class has none
};
} // namespace app
