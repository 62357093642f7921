// setStep() converts a step to a list of moments with times; playing advances along that list. The ghost brush is
// interpolated between the last and the next moment that has a position.
#include "core/lesson/lesson_player.h"

#include <algorithm>
#include <cassert>

namespace core
{
namespace
{
const Stroke& strokeOf(const LessonStep& step, std::size_t entry)
{
    return std::get<Stroke>(step.strokes[entry]);
}
} // namespace

LessonPlayer::LessonPlayer(std::shared_ptr<const Lesson> lesson) : m_lesson(std::move(lesson))
{
    setStep(0);
}

void LessonPlayer::setStep(std::size_t index)
{
    assert(index < m_lesson->steps.size());
    m_step = index;
    m_next = 0;
    m_time = 0;
    m_isPlaying = false;
    layOut();
}

void LessonPlayer::layOut()
{
    m_moments.clear();
    m_duration = 0;
    for (std::size_t i = 0; i < step().strokes.size(); ++i) {
        m_duration += leadTime;
        if (const auto* const stroke = std::get_if<Stroke>(&step().strokes[i]))
            layOut(*stroke, i);
        else
            m_moments.push_back({m_duration, Kind::Command, i, 0});
    }
}

void LessonPlayer::layOut(const Stroke& stroke, std::size_t entry)
{
    const std::vector<StrokeSample>& samples = stroke.samples;
    const bool hasTimes = std::ranges::is_sorted(samples, {}, &StrokeSample::time) && !samples.empty() &&
                          samples.back().time > samples.front().time;
    m_moments.push_back({m_duration, Kind::Begin, entry, 0});
    for (std::size_t i = 0; i < samples.size(); ++i) {
        if (i > 0)
            m_duration += hasTimes ? std::min(samples[i].time - samples[i - 1].time, maxPause) : samplePause;
        m_moments.push_back({m_duration, Kind::Sample, entry, i});
    }
    m_moments.push_back({m_duration, Kind::End, entry, 0});
}

void LessonPlayer::setSpeed(double speed)
{
    m_speed = std::clamp(speed, minSpeed, maxSpeed);
}

LessonCue LessonPlayer::cueOf(const Moment& moment) const
{
    switch (moment.kind) {
    case Kind::Begin:
        return StrokeBegins{strokeOf(step(), moment.entry).settings};
    case Kind::Sample:
        return strokeOf(step(), moment.entry).samples[moment.sample];
    case Kind::Command:
        return std::get<FileCommand>(step().strokes[moment.entry]);
    case Kind::End:
        break;
    }
    return StrokeEnds{};
}

void LessonPlayer::play()
{
    m_end = m_moments.size();
    m_isPlaying = !isAtEnd();
}

void LessonPlayer::playOne()
{
    for (m_end = m_next; m_end < m_moments.size() && m_moments[m_end].entry == m_moments[m_next].entry;)
        ++m_end;
    m_isPlaying = m_end > m_next;
}

std::vector<LessonCue> LessonPlayer::advance(double seconds)
{
    std::vector<LessonCue> due;
    if (!m_isPlaying)
        return due;
    const double end = m_end < m_moments.size() ? m_moments[m_end - 1].time : m_duration;
    m_time = std::min(m_time + seconds * m_speed, end);
    for (; m_next < m_end && m_moments[m_next].time <= m_time; ++m_next)
        due.push_back(cueOf(m_moments[m_next]));
    m_isPlaying = m_next < m_end || m_time < end;
    return due;
}

bool LessonPlayer::isUnderWay() const
{
    return m_next > 0 && (m_moments[m_next - 1].kind == Kind::Begin || m_moments[m_next - 1].kind == Kind::Sample);
}

GhostBrush LessonPlayer::ghostAt(const Moment& moment) const
{
    const StrokeSettings& settings = strokeOf(step(), moment.entry).settings;
    const StrokeSample& sample = strokeOf(step(), moment.entry).samples[moment.sample];
    GhostBrush ghost{sample.rotation.conjugate() * sample.position,
                     {},
                     sample.rotation,
                     sample.radius.value_or(settings.radius),
                     settings.tool,
                     settings.inverted};
    if (settings.brush == BrushShape::Ray || settings.place == Placement::Ray)
        ghost.direction = sample.rotation.conjugate() * sample.direction;
    return ghost;
}

std::optional<GhostBrush> LessonPlayer::ghost() const
{
    const auto isPlace = [](const Moment& moment) { return moment.kind == Kind::Sample; };
    const auto next = std::find_if(m_moments.begin() + static_cast<long>(m_next), m_moments.end(), isPlace);
    const auto last = std::find_if(m_moments.rend() - static_cast<long>(m_next), m_moments.rend(), isPlace);
    if (next == m_moments.end() && last == m_moments.rend())
        return std::nullopt;
    GhostBrush ghost = ghostAt(next == m_moments.end() ? *last : *next);
    ghost.isPressed = isUnderWay();
    if (next == m_moments.end() || last == m_moments.rend())
        return ghost;
    const GhostBrush before = ghostAt(*last);
    const double whole = next->time - last->time,
                 share = whole > 0 ? std::clamp((m_time - last->time) / whole, 0.0, 1.0) : 1;
    ghost.position = before.position + share * (ghost.position - before.position);
    ghost.rotation = before.rotation.slerp(share, ghost.rotation);
    ghost.radius = before.radius + share * (ghost.radius - before.radius);
    if (ghost.direction && before.direction)
        ghost.direction = (*before.direction + share * (*ghost.direction - *before.direction)).eval();
    return ghost;
}
} // namespace core
