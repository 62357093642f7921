#pragma once

// For the lesson's reader and writer only.

#include "core/lesson/lesson_file.h"

namespace core
{
inline constexpr char lessonJsonName[] = "lesson.json";

/// Whether a lesson may call a file so: plain steps with "/" between them, none of them "." or "..", no drive, nothing
/// that a system reads in its own way.
bool isLessonName(std::string_view name);

/// Throws FileError, and LessonError::NoLesson.
LessonFiles lessonFolder(const std::filesystem::path& path);
LessonFiles lessonZip(const std::filesystem::path& path);
} // namespace core
