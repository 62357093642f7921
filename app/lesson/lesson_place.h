#pragma once

#include "core/lesson/lesson.h"

#include <filesystem>
#include <memory>

namespace app
{
/// A step of a lesson.
struct LessonPlace
{
    std::shared_ptr<const core::Lesson> lesson; ///< null: none is open
    std::filesystem::path path;                 ///< of the lesson, for errors
    std::size_t step = 0;
    bool isTeachers = false; ///< the model there has strokes of the teacher's
};
} // namespace app
