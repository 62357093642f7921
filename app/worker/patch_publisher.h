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
    quint64 samples = 0; ///< that the engine consumed
    quint64 droppedSamples = 0;
    quint64 patches = 0;
    double latencyMs = 0; ///< from a sample's post to its patch in the inbox, the last
    double worstLatencyMs = 0;
};

/// Puts what changed in the mesh into the viewers' inboxes, and measures how late. Thread: mesh, except stats().
class PatchPublisher
{
public:
    void setInbox(Source source, std::shared_ptr<PatchInbox> inbox);
    void putWhole(const core::MeshPatch& whole);
    /// Takes the sculptor's patch and puts it into every inbox. Returns the patch; nothing if it is empty, or patches
    /// are hidden.
    std::optional<core::MeshPatch> flush(core::Sculptor& sculptor);
    /// The last flush was so long ago that viewers should see something new.
    bool isDue() const;
    /// While hidden, nothing is flushed.
    void setHidden(bool isHidden) { m_isHidden = isHidden; }
    void beginSample(std::int64_t postedNs) { m_sampledNs = postedNs; }
    void endSample() { m_sampledNs = 0; }
    /// One more sample was consumed.
    void countSample();
    /// The epoch of the last patch.
    quint64 epoch() const { return m_epoch; }

    /// Without dropped samples. Thread: any.
    WorkerStats stats() const;

private:
    void put(const core::MeshPatch& patch);
    void measureLatency();

    std::array<std::shared_ptr<PatchInbox>, sourceCount> m_inboxes;
    bool m_isHidden = false;
    quint64 m_epoch = 0;
    std::int64_t m_sampledNs = 0; ///< when the sample in work was posted; 0: none is
    std::int64_t m_flushedNs = 0;
    mutable std::mutex m_mutex; ///< guards the next
    WorkerStats m_stats;
};
} // namespace app
