#pragma once

#include "core/lesson/lesson_playback.h"

namespace core
{
/// What playing a lesson to its end says of a step.
struct StepCheck
{
    std::vector<std::size_t> idle; ///< strokes and commands that changed nothing, counted from 0
    CheckpointVerdict verdict;     ///< of what the step's strokes leave
};

/// Plays all steps, from the start of the first; `seen` gets what each of them leaves. Throws LessonError. If it is
/// cancelled, the result is not usable. Cost: all strokes, and evaluate() of each step.
std::vector<StepCheck> checkLesson(LessonPlayback& playback,
                                   const std::function<void(std::size_t step, const TriangleMesh& mesh)>& seen,
                                   const JobControl& control = {});
} // namespace core
