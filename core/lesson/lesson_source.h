#pragma once

// Used by the reader and the writer of lessons only.

#include "core/lesson/lesson_file.h"

namespace core
{
inline constexpr char lessonJsonName[] = "lesson.json";

/// Returns whether a file in a lesson may have this name: path components separated by "/", none of them "." or "..",
/// no drive letter, no characters that are special on any system, and at most LessonLimits::maxNameBytes bytes.
bool isLessonName(std::string_view name);

/// Returns a source that reads the lesson's files from a folder. Throws LessonError::NoLesson. The source throws
/// FileError, and LessonError::BadName if a link leads out of the folder.
LessonFiles lessonFolder(const std::filesystem::path& path);
/// Returns a source that reads the lesson's files from a zip. Throws FileError, and LessonError: NoLesson, TooLarge or
/// TooMany. The source throws FileError.
LessonFiles lessonZip(const std::filesystem::path& path);
} // namespace core
