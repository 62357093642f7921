#include "app/lesson/lesson_checker.h"

#include "app/document/document.h"

#include "core/lesson/lesson_playback.h"

#include <algorithm>

namespace app
{
namespace
{
/// 128 at the tolerance, as a fault begins.
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

LessonInquiry::LessonInquiry(Document* document, SculptWorker* worker) : RestingModel(document, worker) {}

LessonInquiry::~LessonInquiry()
{
    end();
}

void LessonInquiry::setPlace(const Place& place)
{
    {
        const std::lock_guard lock(m_mutex);
        m_place = place;
    }
    const bool asks = place.lesson && !place.lesson->steps[place.step].checkpoint.asksNothing();
    stop();
    setWanted(asks);
    askAgain();
}

void LessonInquiry::look(const std::shared_ptr<ModelCopy>& copy, const std::stop_token& stop)
{
    const std::lock_guard lock(m_mutex);
    m_aside.run([copy, place = m_place, stop] { return judge(*copy, place, stop); },
                [this, stop](const Answer& answer) {
                    if (stop.stop_requested())
                        return;
                    setAnswered();
                    Q_EMIT answered(answer.verdict, answer.shades);
                });
}

LessonInquiry::Answer LessonInquiry::judge(const ModelCopy& copy, const Place& place, const std::stop_token& stop)
{
    if (!place.lesson || stop.stop_requested())
        return {};
    const core::Checkpoint& checkpoint = place.lesson->steps[place.step].checkpoint;
    core::TriangleMesh target;
    if (checkpoint.target) {
        core::LessonPlayback playback(place.lesson, place.path);
        try {
            playback.goTo(place.step);
            target = playback.target();
        } catch (const core::LessonError&) { // of a step that cannot be played: who plays it is told
            return {};
        }
    }
    Answer answer{core::evaluate(checkpoint, copy.mesh, checkpoint.target ? &target : nullptr, {stop, {}}), {}};
    if (answer.verdict.target && !stop.stop_requested())
        answer.shades = shadesOf(copy.slots, *answer.verdict.target);
    return answer;
}
} // namespace app
