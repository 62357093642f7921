#pragma once

#include "core/lesson/lesson_playback.h"

namespace core
{
/// The result for one step of playing a lesson to its end.
struct StepCheck
{
    std::vector<std::size_t> idle; ///< indices of strokes and commands that changed nothing, from 0
    CheckpointVerdict verdict;     ///< the step's checkpoint evaluated on the result of its strokes
};

/// Plays all steps from the start of the first. Calls `seen` with the mesh after each step. Throws LessonError. If it
/// is cancelled, the result is not usable. Cost: all strokes, and evaluate() of each step.
std::vector<StepCheck> checkLesson(LessonPlayback& playback,
                                   const std::function<void(std::size_t step, const TriangleMesh& mesh)>& seen,
                                   const JobControl& control = {});
} // namespace core
