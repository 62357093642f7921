#include "app/lesson/lesson_checker.h"

#include "app/document/document.h"

#include "core/lesson/lesson_playback.h"

#include <algorithm>

namespace app
{
namespace
{
/// Returns the distances as shades. A distance equal to the tolerance becomes 128, the value at which faults are
/// coloured.
std::shared_ptr<const core::Footprint> shadesOf(std::vector<core::Slot> slots, const core::TargetVerdict& target)
{
    auto shades = std::make_shared<core::Footprint>();
    shades->slots = std::move(slots);
    shades->weights.reserve(target.distances.size());
    for (const float distance : target.distances)
        shades->weights.push_back(
            static_cast<std::uint8_t>(std::clamp(128 * static_cast<double>(distance) / target.tolerance, 0.0, 255.0)));
    return shades;
}
} // namespace

LessonChecker::LessonChecker(Document* document, SculptWorker* worker)
    : IdleAnalysis(document, worker, AnalysedParts::All)
{}

LessonChecker::~LessonChecker()
{
    cancel();
}

void LessonChecker::setPosition(const LessonPlace& position)
{
    {
        const std::lock_guard lock(m_mutex);
        m_position = position;
    }
    const bool hasCheckpoint = position.lesson && !position.lesson->steps[position.step].checkpoint.asksNothing();
    stop();
    setActive(hasCheckpoint);
    runNow();
}

void LessonChecker::analyse(const std::shared_ptr<ModelCopy>& copy, const std::stop_token& stop)
{
    const std::lock_guard lock(m_mutex);
    m_background.run([copy, position = m_position, stop] { return evaluate(*copy, position, stop); },
                     [this, stop](const Result& result) {
                         if (stop.stop_requested())
                             return;
                         setFinished();
                         Q_EMIT finished(result.verdict, result.shades);
                     });
}

LessonChecker::Result LessonChecker::evaluate(const ModelCopy& copy, const LessonPlace& position,
                                              const std::stop_token& stop)
{
    if (!position.lesson || stop.stop_requested())
        return {};
    const core::Checkpoint& checkpoint = position.lesson->steps[position.step].checkpoint;
    core::TriangleMesh target;
    if (checkpoint.target) {
        core::LessonPlayback playback(position.lesson, position.path);
        try {
            playback.goTo(position.step);
            target = playback.target();
        } catch (const core::LessonError&) { // the step cannot be played; the code that plays it reports the error
            return {};
        }
    }
    Result result{core::evaluate(checkpoint, copy.mesh, checkpoint.target ? &target : nullptr, {stop, {}}), {}};
    if (result.verdict.target && !stop.stop_requested())
        result.shades = shadesOf(copy.slots, *result.verdict.target);
    return result;
}
} // namespace app
