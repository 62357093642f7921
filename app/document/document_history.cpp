#include "app/document/document_history.h"

#include "app/document/document_queue.h"
#include "app/document/stroke_command.h"
#include "app/worker/sculpt_worker.h"

#include <algorithm>
#include <utility>

namespace app
{
DocumentHistory::DocumentHistory(SculptWorker* worker, DocumentQueue* queue)
    : m_worker(worker)
    , m_queue(queue)
    , m_store([worker](auto job) { worker->post(std::move(job)); })
{}

bool DocumentHistory::canUndo() const
{
    return m_queue->isStrokeOpen() || m_queue->hasUnreported() || m_store.canUndo(m_stack.index());
}

bool DocumentHistory::canRedo() const
{
    return !m_queue->isStrokeOpen() && !m_queue->hasUnreported() && m_stack.canRedo() &&
           m_store.canRedo(m_stack.index());
}

QString DocumentHistory::undoText() const
{
    if (!canUndo())
        return {};
    return m_queue->isStrokeOpen() || m_queue->hasUnreported() ? m_strokeText : m_stack.undoText();
}

QString DocumentHistory::redoText() const
{
    return canRedo() ? m_stack.redoText() : QString();
}

void DocumentHistory::undo()
{
    m_queue->enqueue([this] {
        if (m_store.canUndo(m_stack.index()))
            holdAndMoveTo(m_stack.index() - 1);
    });
}

void DocumentHistory::redo()
{
    m_queue->enqueue([this] {
        if (m_stack.canRedo() && m_store.canRedo(m_stack.index()))
            holdAndMoveTo(m_stack.index() + 1);
    });
}

void DocumentHistory::goTo(int index)
{
    m_queue->enqueue([this, index] { holdAndMoveTo(std::clamp(index, m_store.firstIndex(), m_store.lastIndex())); });
}

void DocumentHistory::holdAndMoveTo(int index)
{
    if (!m_worker->strokes().hold()) // another source's stroke is open: waits for its end
        return goTo(index);
    moveTo(index);
    m_worker->strokes().release();
}

void DocumentHistory::moveTo(int index)
{
    m_queue->move([this, index] { m_stack.setIndex(index); }, [this] { Q_EMIT moved(); });
}

void DocumentHistory::push(const StepDescription& step, const std::shared_ptr<core::MeshDelta>& delta)
{
    const int index = m_stack.index();
    m_store.add(index, delta);
    m_stack.push(new StrokeCommand(step.text, step.marks, &m_store, index));
}

void DocumentHistory::clear(bool isWhole)
{
    m_store.clear();
    m_stack.clear();
    m_isWhole = isWhole;
}

void DocumentHistory::restore(const core::JournalHistory& history,
                              const std::vector<std::shared_ptr<core::MeshDelta>>& deltas)
{
    const QSignalBlocker quiet(m_stack); // these steps are not made by the user
    for (int i = 0; i < static_cast<int>(history.steps.size()); ++i) {
        const StepDescription step = StrokeStep::fromJournal(history.steps[static_cast<std::size_t>(i)]);
        m_stack.push(new StrokeCommand(step.text, step.marks, &m_store, i));
    }
    m_isWhole = history.isWhole;
    m_stack.resetClean();
    if (history.saved && static_cast<int>(*history.saved) <= m_stack.count()) {
        m_stack.setIndex(static_cast<int>(*history.saved));
        m_stack.setClean();
    }
    m_stack.setIndex(static_cast<int>(history.present));
    m_store.restore(deltas, static_cast<int>(history.present));
}
} // namespace app
