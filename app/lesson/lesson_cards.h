#pragma once

#include "core/lesson/lesson.h"
#include "ui/lesson/lesson_panel.h"

namespace app
{
/// Returns the lesson's picture with this name; null if there is none that can be read.
QImage pictureOf(const core::Lesson& lesson, const std::string& picture);
/// Returns the card shown when choosing a lesson: texts in the user's language, and the picture of the last step.
ui::LessonCard cardOf(const QString& name, const core::Lesson& lesson);
/// Returns the cards of the bundled lessons.
QList<ui::LessonCard> bundledLessonCards();
} // namespace app
