#include "vr/frame/frame_timing.h"

#include <cmath>
#include <utility>

namespace vr
{
void FrameCosts::add(const FrameCost& cost)
{
    m_waiting.push_back(cost);
    const std::unique_lock lock(m_mutex, std::try_to_lock);
    if (!lock)
        return;
    for (const FrameCost& one : m_waiting) {
        m_ring[m_frames++ % capacity] = one;
        m_lost += one.lost;
    }
    m_waiting.clear();
}

std::vector<FrameCost> FrameCosts::last() const
{
    std::vector<FrameCost> costs;
    costs.reserve(capacity);
    const std::lock_guard lock(m_mutex);
    for (std::uint64_t i = m_frames < capacity ? 0 : m_frames - capacity; i < m_frames; ++i)
        costs.push_back(m_ring[i % capacity]);
    return costs;
}

std::uint64_t FrameCosts::frames() const
{
    const std::lock_guard lock(m_mutex);
    return m_frames;
}

std::uint64_t FrameCosts::lostFrames() const
{
    const std::lock_guard lock(m_mutex);
    return m_lost;
}

std::uint32_t LostFrames::count(std::int64_t displayNs, std::int64_t periodNs, bool isShown)
{
    const std::int64_t before = std::exchange(m_before, isShown ? displayNs : 0);
    if (!isShown || before == 0 || periodNs <= 0)
        return 0;
    const auto periods = std::llround(static_cast<double>(displayNs - before) / static_cast<double>(periodNs));
    return periods > 1 ? static_cast<std::uint32_t>(periods - 1) : 0;
}

void PhaseClock::ends(FramePhase phase)
{
    const double now = threadMilliseconds();
    m_cost.cpuMs[static_cast<std::size_t>(phase)] += now - std::exchange(m_lastMs, now);
}
} // namespace vr
