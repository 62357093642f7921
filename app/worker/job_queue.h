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
/// Whose hand strokes, and whose eyes look: mouse and pen at the window, wands and headset. The drawings only look, and
/// so does the mouse over the VR simulator's picture.
enum class Source { Desktop, Headset, Drawings, Simulator };
inline constexpr std::size_t sourceCount = 4;

struct BeginStroke
{
    core::StrokeSettings settings;
    Source source = Source::Desktop;
    bool onlyAdds = false; ///< a sphere, or nothing
};
struct Sample
{
    core::StrokeSample sample;
    std::int64_t postedNs = 0; ///< steady clock
    bool first = false;        ///< of its stroke; set by the queue
};
struct EndStroke
{
    core::StrokeEnd how = core::StrokeEnd::Kept;
};
/// Anything else that needs the mesh.
using Task = std::function<void()>;
using Job = std::variant<BeginStroke, Sample, EndStroke, Task>;

/// A ray of which a viewer wants to know where it meets the surface, and what a brush would take there; of a spherical
/// brush that stands where the hand is (core::Placement::Point), which of the surface's points within it is nearest to
/// the ray's origin.
struct Question
{
    Source source;
    core::Ray ray;
    std::optional<core::StrokeSettings> brush;
};

std::int64_t steadyNs();

/// Of `count` samples that pile up, whether the one at `i` is dropped: every other one, but not a stroke's first nor
/// the last.
constexpr bool isThinnedOut(std::size_t i, std::size_t count, bool isFirst)
{
    return !isFirst && i + 1 != count && i % 2 == 0;
}

/// What the mesh thread has to do: jobs in order, and the newest question of each viewer. One of each goes before the
/// next job; those that come meanwhile wait for it, or a viewer that asks without end would let nobody work. Any
/// thread.
class JobQueue
{
public:
    /// More samples than this never wait: then every other one of those that wait is dropped, but for the stroke's
    /// first and its last.
    static constexpr std::size_t maxWaitingSamples = 16;

    void push(Job job);
    /// Takes the place of the viewer's question before, if that is not answered yet.
    void ask(const Question& question);
    /// No job is given out any more.
    void stop();

    /// Waits for a question or a job; nothing after stop().
    std::optional<std::variant<Question, Job>> next();
    /// All that wait now, by Source.
    std::array<std::optional<Question>, sourceCount> takeQuestions();
    bool hasSample() const;
    std::uint64_t droppedSamples() const;

private:
    void thinSamples();
    std::optional<Question> popQuestion();

    mutable std::mutex m_mutex;
    std::condition_variable m_wake;
    std::deque<Job> m_jobs;
    std::size_t m_waitingSamples = 0; ///< at the end of m_jobs
    bool m_strokeBegan = false;       ///< and no sample followed yet
    std::uint64_t m_dropped = 0;
    std::array<std::optional<Question>, sourceCount> m_questions;
    std::array<bool, sourceCount> m_hasAsked{}; ///< since the last job was given out
    bool m_stopped = false;
};
} // namespace app
