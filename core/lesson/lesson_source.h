#pragma once

// Used by the reader and the writer of lessons only.

#include "core/lesson/lesson_file.h"

namespace core
{
inline constexpr char lessonJsonName[] = "lesson.json";

/// Returns whether a file in a lesson may have this name: path components separated by "/", none of them "." or "..",
/// no drive letter, and no characters that are special on any system.
bool isLessonName(std::string_view name);

/// Returns a source that reads the lesson's files from a folder. Throws FileError, and LessonError::NoLesson.
LessonFiles lessonFolder(const std::filesystem::path& path);
LessonFiles lessonZip(const std::filesystem::path& path);
} // namespace core
