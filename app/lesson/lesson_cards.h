#pragma once

#include "core/lesson/lesson.h"
#include "ui/lesson/lesson_panel.h"

namespace app
{
/// Returns a picture of the lesson by its name there; null if it has none.
QImage pictureOf(const core::Lesson& lesson, const std::string& picture);
/// Returns what a lesson is chosen by: its words in the person's language, and the picture of its end.
ui::LessonCard cardOf(const QString& name, const core::Lesson& lesson);
/// Returns the cards of the lessons that come with the program.
QList<ui::LessonCard> bundledLessonCards();
} // namespace app
