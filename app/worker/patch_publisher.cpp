#include "app/worker/patch_publisher.h"

#include "core/sculpt/sculptor.h"

#include <algorithm>
#include <utility>

namespace app
{
namespace
{
constexpr std::int64_t flushIntervalNs = 8'000'000; ///< half a frame of a 60 Hz screen
} // namespace

void PatchPublisher::setInbox(Source source, std::shared_ptr<PatchInbox> inbox)
{
    m_inboxes[static_cast<std::size_t>(source)] = std::move(inbox);
}

void PatchPublisher::putWhole(const core::MeshPatch& whole)
{
    m_epoch = whole.epoch;
    put(whole);
}

std::optional<core::MeshPatch> PatchPublisher::flush(core::Sculptor& sculptor)
{
    if (m_isHidden)
        return std::nullopt;
    m_flushedNs = steadyNs();
    core::MeshPatch patch = sculptor.takePatch();
    if (patch.empty())
        return std::nullopt;
    patch.sampledNs = m_sampledNs;
    m_epoch = patch.epoch;
    put(patch);
    measureLatency();
    return patch;
}

void PatchPublisher::put(const core::MeshPatch& patch)
{
    for (const auto& inbox : m_inboxes)
        if (inbox)
            inbox->put(patch);
}

bool PatchPublisher::isDue() const
{
    return steadyNs() - m_flushedNs > flushIntervalNs;
}

void PatchPublisher::measureLatency()
{
    const std::lock_guard lock(m_mutex);
    ++m_stats.patches;
    if (m_sampledNs == 0)
        return;
    m_stats.latencyMs = static_cast<double>(steadyNs() - m_sampledNs) * 1e-6;
    m_stats.worstLatencyMs = std::max(m_stats.worstLatencyMs, m_stats.latencyMs);
}

void PatchPublisher::countSample()
{
    const std::lock_guard lock(m_mutex);
    ++m_stats.samples;
}

WorkerStats PatchPublisher::stats() const
{
    const std::lock_guard lock(m_mutex);
    return m_stats;
}
} // namespace app
