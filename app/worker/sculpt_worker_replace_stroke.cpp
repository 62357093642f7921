// A stroke that was done before, by another brush or as it was. One job.

#include "app/worker/sculpt_worker.h"

namespace app
{
void SculptWorker::hidePatches()
{
    m_queue.push(Task([this] { m_isQuiet = true; }));
}

void SculptWorker::redoStroke(const StrokeAgain& again)
{
    ++m_strokesBegun;
    m_queue.push(Task([this, again] {
        const bool isDone = again.stroke && doAgain(again);
        m_isQuiet = false;
        if (!isDone)
            return giveBack(again);
        EndStroke end;
        run(end);
    }));
}

/// False if it was stopped: the mesh is then as if it had not begun.
bool SculptWorker::doAgain(const StrokeAgain& again)
{
    BeginStroke begin{again.stroke->settings, Source::Desktop, again.before.added};
    run(begin);
    m_report.isAgain = true;
    for (const core::StrokeSample& sample : again.stroke->samples) {
        if (again.stop.stop_requested())
            break;
        if (!isOver(sample))
            apply(sample);
    }
    if (!again.stop.stop_requested())
        return true;
    if (m_sculptor && m_sculptor->strokeOpen()) {
        core::MeshDelta delta = m_sculptor->endStroke();
        m_sculptor->swap(delta);
    }
    return false;
}

void SculptWorker::giveBack(const StrokeAgain& again)
{
    m_report = again.before;
    m_report.isAgain = true;
    m_report.delta = m_sculptor ? again.giveBack(*m_sculptor) : nullptr;
    report();
}
} // namespace app
