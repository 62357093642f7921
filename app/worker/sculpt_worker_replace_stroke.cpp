// A stroke that was done before, by another brush or as it was. One job.

#include "app/worker/sculpt_worker.h"

namespace app
{
void SculptWorker::hidePatches()
{
    m_queue.push(Task([this] { m_isQuiet = true; }));
}

void SculptWorker::replaceLastStroke(const StrokeReplacement& replacement)
{
    ++m_strokesBegun;
    m_queue.push(Task([this, replacement] {
        const bool isDone = replacement.stroke && doAgain(replacement);
        m_isQuiet = false;
        if (!isDone)
            return restoreReplaced(replacement);
        EndStroke end;
        run(end);
    }));
}

/// False if it was stopped: the mesh is then as if it had not begun.
bool SculptWorker::doAgain(const StrokeReplacement& replacement)
{
    BeginStroke begin{replacement.stroke->settings, Source::Desktop, replacement.before.added};
    run(begin);
    m_report.isReplacement = true;
    for (const core::StrokeSample& sample : replacement.stroke->samples) {
        if (replacement.stop.stop_requested())
            break;
        if (!isOver(sample))
            apply(sample);
    }
    if (!replacement.stop.stop_requested())
        return true;
    if (m_sculptor && m_sculptor->strokeOpen()) {
        core::MeshDelta delta = m_sculptor->endStroke();
        m_sculptor->swap(delta);
    }
    return false;
}

void SculptWorker::restoreReplaced(const StrokeReplacement& replacement)
{
    m_report = replacement.before;
    m_report.isReplacement = true;
    m_report.delta = m_sculptor ? replacement.restoreReplaced(*m_sculptor) : nullptr;
    report();
}
} // namespace app
