#include "core/lesson/lesson_check.h"

#include "core/mesh/mesh_builder.h"

namespace core
{
namespace
{
/// Returns the step's share of the progress: its strokes, plus one for its checkpoint.
std::size_t costOf(const LessonStep& step)
{
    return step.strokes.size() + 1;
}

std::size_t costOf(const Lesson& lesson)
{
    std::size_t cost = 0;
    for (const LessonStep& step : lesson.steps)
        cost += costOf(step);
    return cost;
}

CheckpointVerdict verdictOf(LessonPlayback& playback, const TriangleMesh& mesh, const JobControl& control)
{
    const Checkpoint& checkpoint = playback.step().checkpoint;
    const TriangleMesh target = checkpoint.target ? playback.target() : TriangleMesh();
    return evaluate(checkpoint, mesh, checkpoint.target ? &target : nullptr, {control.stop, {}});
}
} // namespace

std::vector<StepCheck> checkLesson(LessonPlayback& playback,
                                   const std::function<void(std::size_t step, const TriangleMesh& mesh)>& seen,
                                   const JobControl& control)
{
    const double all = static_cast<double>(costOf(playback.lesson()));
    std::size_t before = 0;
    std::vector<StepCheck> checks;
    for (std::size_t i = 0; i < playback.lesson().steps.size() && !control.isCancelled(); ++i) {
        playback.goTo(i);
        StepCheck& check = checks.emplace_back();
        while (playback.done() < playback.step().strokes.size() && !control.isCancelled()) {
            if (!playback.playNext())
                check.idle.push_back(playback.done() - 1);
            control.reportProgress(static_cast<double>(before + playback.done()) / all);
        }
        if (control.isCancelled())
            break;
        const TriangleMesh mesh = extractMesh(playback.mesh());
        check.verdict = verdictOf(playback, mesh, control);
        seen(i, mesh);
        before += costOf(playback.step());
        control.reportProgress(static_cast<double>(before) / all);
    }
    return checks;
}
} // namespace core
