#include "vr/frame/frame_timing.h"

#include <cmath>
#include <utility>

namespace vr
{
void FrameTimings::add(const FrameTiming& timing)
{
    m_pending.push_back(timing);
    const std::unique_lock lock(m_mutex, std::try_to_lock);
    if (!lock)
        return;
    for (const FrameTiming& one : m_pending) {
        m_ring[m_frames++ % capacity] = one;
        m_dropped += one.dropped;
    }
    m_pending.clear();
}

std::vector<FrameTiming> FrameTimings::recent() const
{
    std::vector<FrameTiming> timings;
    timings.reserve(capacity);
    const std::lock_guard lock(m_mutex);
    for (std::uint64_t i = m_frames < capacity ? 0 : m_frames - capacity; i < m_frames; ++i)
        timings.push_back(m_ring[i % capacity]);
    return timings;
}

std::uint64_t FrameTimings::frames() const
{
    const std::lock_guard lock(m_mutex);
    return m_frames;
}

std::uint64_t FrameTimings::droppedFrames() const
{
    const std::lock_guard lock(m_mutex);
    return m_dropped;
}

std::uint32_t DroppedFrameCounter::count(std::int64_t displayNs, std::int64_t periodNs, bool isShown)
{
    const std::int64_t before = std::exchange(m_before, isShown ? displayNs : 0);
    if (!isShown || before == 0 || periodNs <= 0)
        return 0;
    const auto periods = std::llround(static_cast<double>(displayNs - before) / static_cast<double>(periodNs));
    return periods > 1 ? static_cast<std::uint32_t>(periods - 1) : 0;
}

void PhaseTimer::endPhase(FramePhase phase)
{
    const double now = core::threadCpuMs();
    m_timing.cpuMs[static_cast<std::size_t>(phase)] += now - std::exchange(m_lastMs, now);
}
} // namespace vr
