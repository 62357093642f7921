#pragma once

#include "core/lesson/lesson_file.h"

#include <QString>
#include <QStringList>

namespace app
{
/// Returns the folder names of the bundled lessons (resources/lessons), the easiest first.
QStringList bundledLessons();

/// Returns a lesson by its path or by the name of a bundled lesson. An existing file or folder takes precedence. Throws
/// core::LessonError and core::FileError.
core::Lesson readLesson(const QString& pathOrName);
/// Reads a lesson like readLesson(), but a bundled lesson takes precedence, so that files in the working directory
/// cannot replace it.
core::Lesson readLessonOfClass(const QString& pathOrName);
} // namespace app
