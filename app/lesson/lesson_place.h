#pragma once

#include "core/lesson/lesson.h"

#include <filesystem>
#include <memory>

namespace app
{
/// A place in a lesson: the lesson and its present step.
struct LessonPlace
{
    std::shared_ptr<const core::Lesson> lesson; ///< null: no lesson is open
    std::filesystem::path path;                 ///< path of the lesson, for error messages
    std::size_t step = 0;                       ///< step index, from 0
    bool isTeachers = false;                    ///< whether the model contains strokes of the demonstration
};
} // namespace app
