#pragma once

#include "core/lesson/lesson_file.h"

#include <QString>
#include <QStringList>

namespace app
{
/// The lessons that come with the program (resources/lessons), by the names of their folders, the easiest first.
QStringList bundledLessons();

/// A lesson by its path, or by the name of one that comes with the program; a file or folder of that name goes first.
/// Throws core::LessonError and core::FileError.
core::Lesson readLesson(const QString& pathOrName);
/// Reads a lesson as readLesson() does, but of two with one name that of the program: what lies in the folder that the
/// program was started in does not count.
core::Lesson readLessonOfClass(const QString& pathOrName);
} // namespace app
