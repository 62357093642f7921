#pragma once

#include "core/stroke/stroke.h"

#include <array>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <functional>
#include <mutex>
#include <optional>
#include <variant>

namespace app
{
/// The sources of strokes and questions: desktop (mouse and pen) and headset (wands). Drawings and the mouse over the
/// VR simulator's picture only view the model and never sculpt.
enum class Source { Desktop, Headset, Drawings, Simulator };
inline constexpr std::size_t sourceCount = 4;

struct BeginStroke
{
    core::StrokeSettings settings;
    Source source = Source::Desktop;
    bool onlyAdds = false; ///< the stroke may add a sphere and does nothing else
};
struct Sample
{
    core::StrokeSample sample;
    std::int64_t postedNs = 0; ///< time of posting, ns of the steady clock
    bool first = false;        ///< whether it is the stroke's first sample; set by the queue
};
struct EndStroke
{
    core::StrokeEnd how = core::StrokeEnd::Kept;
};
/// Any other job that needs the mesh.
using Task = std::function<void()>;
using Job = std::variant<BeginStroke, Sample, EndStroke, Task>;

/// A viewer's question where a ray meets the surface, and which vertices a brush would select there. For a spherical
/// brush placed at the input's position (core::Placement::Point), the question is which surface point within the brush
/// is nearest to the ray's origin.
struct Question
{
    Source source;
    core::Ray ray;
    std::optional<core::StrokeSettings> brush;
};

std::int64_t steadyNs();

/// Returns whether sample `i` of `count` waiting samples is dropped: every second one, except the last and the stroke's
/// first sample. `isFirst`: it is the stroke's first sample.
constexpr bool isThinnedOut(std::size_t i, std::size_t count, bool isFirst)
{
    return !isFirst && i + 1 != count && i % 2 == 0;
}

/// The work of the mesh thread: jobs in order, and the newest question of each viewer. At most one question of each
/// viewer is answered before the next job, so that frequent questions cannot delay jobs forever. Thread: any.
class JobQueue
{
public:
    /// Limit of waiting samples. Beyond it every second waiting sample is dropped, except the stroke's first sample and
    /// the last one.
    static constexpr std::size_t maxWaitingSamples = 16;

    void push(Job job);
    /// Sets the viewer's question. Replaces an earlier question that is not answered yet.
    void ask(const Question& question);
    /// Drops all jobs; next() returns nothing from now on.
    void stop();

    /// Waits for a question or a job and returns it; nothing after stop().
    std::optional<std::variant<Question, Job>> next();
    /// Returns all waiting questions, by Source, and removes them.
    std::array<std::optional<Question>, sourceCount> takeQuestions();
    bool hasSample() const;
    std::uint64_t droppedSamples() const;

private:
    void thinSamples();
    std::optional<Question> popQuestion();

    mutable std::mutex m_mutex;
    std::condition_variable m_wake;
    std::deque<Job> m_jobs;
    std::size_t m_waitingSamples = 0; ///< number of samples at the end of m_jobs
    bool m_strokeBegan = false;       ///< a stroke has begun and no sample of it has been posted yet
    std::uint64_t m_dropped = 0;
    std::array<std::optional<Question>, sourceCount> m_questions;
    std::array<bool, sourceCount> m_hasAsked{}; ///< viewers whose question was returned since the last job
    bool m_stopped = false;
};
} // namespace app
