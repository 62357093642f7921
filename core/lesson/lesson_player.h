#pragma once

#include "core/lesson/lesson.h"

#include <memory>
#include <optional>

namespace core
{
struct StrokeBegins
{
    StrokeSettings settings;
};
struct StrokeEnds
{};
/// The next action of the teacher. Executing all cues in order, without omissions, reproduces the teacher's model bit
/// for bit.
using LessonCue = std::variant<StrokeBegins, StrokeSample, StrokeEnds, FileCommand>;

/// The teacher's brush as displayed during playback: at work, and between strokes. Model space, mm.
struct GhostBrush
{
    Vec3 position = Vec3::Zero(); ///< position of the brush, or origin of its ray
    /// Direction of the ray. Missing: the brush is at the position, or on the surface near it.
    std::optional<Vec3> direction;
    /// Orientation of the model in the teacher's world, as on a turntable.
    Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
    double radius = 0;
    Tool tool = Tool::Pull;
    bool isInverted = false;
    bool isPressed = false;
};

/// Plays the teacher's strokes step by step. It computes where the brush is at each moment and which cues are due. It
/// has neither a clock nor a mesh. The caller passes the elapsed time and executes the cues on the mesh thread, without
/// dropping samples (LessonPlayback, or the window's stroke path). Thread: any one thread.
class LessonPlayer
{
public:
    static constexpr double minSpeed = 0.25, maxSpeed = 4;
    static constexpr double leadTime = 0.6;     ///< seconds before the first stroke or command and between any two
    static constexpr double samplePause = 0.05; ///< seconds between two samples of a stroke without times
    /// Seconds; longer pauses of the teacher between two samples are shortened to this.
    static constexpr double maxPause = 1;

    /// Starts at the beginning of the first step, paused. Precondition: the lesson has at least one step.
    explicit LessonPlayer(std::shared_ptr<const Lesson> lesson);

    const Lesson& lesson() const { return *m_lesson; }
    std::size_t stepIndex() const { return m_step; }
    const LessonStep& step() const { return m_lesson->steps[m_step]; }
    /// Goes to the start of a step and pauses. Precondition: the step exists.
    void setStep(std::size_t index);

    double duration() const { return m_duration; } ///< seconds that this step takes at the teacher's speed
    double time() const { return m_time; }         ///< current time in the step, seconds, 0 to duration()
    double speed() const { return m_speed; }
    void setSpeed(double speed); ///< clamped to minSpeed to maxSpeed

    bool isPlaying() const { return m_isPlaying; }
    void play();
    /// Plays to the end of the stroke or command in progress, or else of the next one, and pauses there.
    void playOne();
    void pause() { m_isPlaying = false; }
    bool isAtEnd() const { return m_next == m_moments.size() && m_time >= m_duration; }

    /// Advances playback by elapsed time in seconds and returns the cues that became due, in order. Returns nothing
    /// while paused. Pauses at the end of what play() or playOne() requested.
    std::vector<LessonCue> advance(double seconds);

    /// Returns the brush at the current time; nothing in a step without strokes.
    std::optional<GhostBrush> ghost() const;

private:
    enum class Kind { Begin, Sample, End, Command };
    struct Moment
    {
        double time; ///< seconds from the step's start
        Kind kind;
        std::size_t entry, sample;
    };

    void layOut();
    void layOut(const Stroke& stroke, std::size_t entry);
    LessonCue cueOf(const Moment& moment) const;
    bool isUnderWay() const;
    GhostBrush ghostAt(const Moment& moment) const;

    std::shared_ptr<const Lesson> m_lesson;
    std::size_t m_step = 0;
    std::vector<Moment> m_moments; ///< cues of the step with their times, in order of time
    std::size_t m_next = 0;        ///< index of the next moment to be played
    std::size_t m_end = 0;         ///< index of the moment at which playing stops
    double m_duration = 0, m_time = 0, m_speed = 1;
    bool m_isPlaying = false;
};
} // namespace core
