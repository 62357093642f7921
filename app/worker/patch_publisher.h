#pragma once

#include "app/worker/job_queue.h"
#include "app/worker/patch_inbox.h"

#include <QtGlobal>

namespace core
{
class Sculptor;
}

namespace app
{
struct WorkerStats
{
    quint64 samples = 0; ///< samples consumed by the engine
    quint64 droppedSamples = 0;
    quint64 patches = 0;
    double latencyMs = 0; ///< time from posting the latest sample to its patch in the inboxes, ms
    double worstLatencyMs = 0;
};

/// Puts changes of the mesh into the viewers' inboxes, and measures the latency. Thread: mesh, except stats().
class PatchPublisher
{
public:
    void setInbox(Source source, std::shared_ptr<PatchInbox> inbox);
    void putWhole(const core::MeshPatch& whole);
    /// Puts the sculptor's patch into every inbox and returns it. Returns nothing if the patch is empty or patches are
    /// hidden.
    std::optional<core::MeshPatch> flush(core::Sculptor& sculptor);
    /// Returns whether the last flush was more than half a frame (8 ms) ago.
    bool isDue() const;
    /// Sets whether patches are hidden. While they are, flush() does nothing, and changes accumulate in the sculptor.
    void setHidden(bool isHidden) { m_isHidden = isHidden; }
    void beginSample(std::int64_t postedNs) { m_sampledNs = postedNs; }
    void endSample() { m_sampledNs = 0; }
    /// Counts a consumed sample.
    void countSample();
    /// Returns the epoch of the last patch.
    quint64 epoch() const { return m_epoch; }

    /// Returns the statistics, except for dropped samples. Thread: any.
    WorkerStats stats() const;

private:
    void put(const core::MeshPatch& patch);
    void measureLatency();

    std::array<std::shared_ptr<PatchInbox>, sourceCount> m_inboxes;
    bool m_isHidden = false;
    quint64 m_epoch = 0;
    std::int64_t m_sampledNs = 0; ///< time of posting of the present sample, ns; 0: none
    std::int64_t m_flushedNs = 0;
    mutable std::mutex m_mutex; ///< guards m_stats
    WorkerStats m_stats;
};
} // namespace app
