#include "core/lesson/lesson_check.h"

#include "core/mesh/mesh_builder.h"

namespace core
{
namespace
{
/// A step without strokes counts as one, for its checkpoint.
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

CheckpointVerdict verdictOf(LessonStage& stage, const TriangleMesh& mesh, const JobWatch& watch)
{
    const Checkpoint& checkpoint = stage.step().checkpoint;
    const TriangleMesh target = checkpoint.target ? stage.target() : TriangleMesh();
    return judge(checkpoint, mesh, checkpoint.target ? &target : nullptr, {watch.stop, {}});
}
} // namespace

std::vector<StepTrial> tryLesson(LessonStage& stage, const std::function<void(std::size_t step, const TriangleMesh& mesh)>& seen, const JobWatch& watch)
{
    const double all = static_cast<double>(costOf(stage.lesson()));
    std::size_t before = 0;
    std::vector<StepTrial> trials;
    for (std::size_t i = 0; i < stage.lesson().steps.size() && !watch.stopped(); ++i) {
        stage.goTo(i);
        StepTrial& trial = trials.emplace_back();
        while (stage.done() < stage.step().strokes.size() && !watch.stopped()) {
            if (!stage.playNext())
                trial.idle.push_back(stage.done() - 1);
            watch.reached(static_cast<double>(before + stage.done()) / all);
        }
        if (watch.stopped())
            break;
        const TriangleMesh mesh = extractMesh(stage.mesh());
        trial.verdict = verdictOf(stage, mesh, watch);
        seen(i, mesh);
        before += costOf(stage.step());
        watch.reached(static_cast<double>(before) / all);
    }
    return trials;
}
} // namespace core
