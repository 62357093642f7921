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

/// The lesson of a class, which each turn may begin with. Thread: gui.
class ClassLesson
{
    Q_DECLARE_TR_FUNCTIONS(app::ClassLesson)

public:
    /// `lesson`: ui::Classroom::lesson. Owns none of the arguments; all must outlive this.
    ClassLesson(const QString& lesson, ui::MainWindow* window, Document* document);

    bool isThere() const { return m_place.lesson != nullptr; }
    ui::LessonCard card() const;
    /// Opens the lesson's first model.
    void open() const;
    /// Begins the lesson with the open model, and shows the lesson panel.
    void begin() const { resume(m_place); }
    void resume(const LessonPlace& place) const;
    /// Returns the present place in the lesson; nothing if no lesson is open.
    std::optional<LessonPlace> place() const;
    /// Returns the noted place with its lesson filled in; nothing if the class now has another lesson, or one without
    /// that step.
    std::optional<LessonPlace> find(const LessonPlace& noted) const;
    /// Stops the lesson's demonstration. Returns the present place in the lesson; nothing if no lesson is open.
    std::optional<LessonPlace> stop() const;

private:
    ui::MainWindow* m_window;
    Document* m_document;
    LessonPlace m_place; ///< the first step of the class's lesson; without a lesson if the class has none
};
} // namespace app
