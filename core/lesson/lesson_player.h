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
/// What the teacher does next. Done one after the other, without one left out, the model becomes the teacher's to the
/// bit.
using LessonCue = std::variant<StrokeBegins, StrokeSample, StrokeEnds, ModelCommand>;

/// The teacher's brush as it is seen while it works, and on its way from stroke to stroke. In the model's space, mm.
struct GhostBrush
{
    Vec3 position = Vec3::Zero(); ///< of the brush, or where its ray comes from
    /// Of the ray; missing: the brush is at the position, or on the surface near it.
    std::optional<Vec3> direction;
    /// Of the model in the teacher's world, as on a turntable.
    Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
    double radius = 0;
    Tool tool = Tool::Pull;
    bool isInverted = false;
    bool isPressed = false;
};

/// Plays the teacher's strokes of one step after another: says at each moment where the brush is and what is due. It
/// has no clock and no mesh: whoever has them tells it of the time that went by, and does on the mesh thread what it
/// hands out (LessonPlayback, or the window's stroke path, where no sample may be dropped). Any one thread.
class LessonPlayer
{
public:
    static constexpr double minSpeed = 0.25, maxSpeed = 4;
    static constexpr double leadTime = 0.6;     ///< s, from the start, and from one stroke or command to the next
    static constexpr double samplePause = 0.05; ///< s, from sample to sample of a stroke without times
    static constexpr double maxPause = 1;       ///< s, between two samples: who thought it over need not be watched

    /// At the start of the first step, paused. The lesson has a step at least.
    explicit LessonPlayer(std::shared_ptr<const Lesson> lesson);

    const Lesson& lesson() const { return *m_lesson; }
    std::size_t stepIndex() const { return m_step; }
    const LessonStep& step() const { return m_lesson->steps[m_step]; }
    /// At its start, paused. It is one of the lesson's.
    void setStep(std::size_t index);

    double duration() const { return m_duration; } ///< s, of this step, as the teacher went
    double time() const { return m_time; }         ///< s, 0 to duration()
    double speed() const { return m_speed; }
    void setSpeed(double speed); ///< the nearest that there is

    bool isPlaying() const { return m_isPlaying; }
    void play();
    /// Only to the end of the stroke or command that is under way, or else of the next one.
    void playOne();
    void pause() { m_isPlaying = false; }
    bool isAtEnd() const { return m_next == m_moments.size() && m_time >= m_duration; }

    /// So much time went by: what became due, in order. Nothing while it is paused. It pauses at the end of what it is
    /// to play.
    std::vector<LessonCue> advance(double seconds);

    /// Nothing in a step without strokes.
    std::optional<GhostBrush> ghost() const;

private:
    enum class Kind { Begin, Sample, End, Command };
    struct Moment
    {
        double time; ///< s
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
    std::vector<Moment> m_moments; ///< of the step, by time
    std::size_t m_next = 0;        ///< the first that is not done
    std::size_t m_end = 0;         ///< the first that is not to be played
    double m_duration = 0, m_time = 0, m_speed = 1;
    bool m_isPlaying = false;
};
} // namespace core
