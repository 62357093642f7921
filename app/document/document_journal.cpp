#include "app/document/document_journal.h"

#include "app/document/document.h"
#include "app/document/stroke_command.h"
#include "app/model/model_change_job.h"
#include "app/model/model_loader.h"
#include "app/recovery/recovery_store.h"
#include "app/worker/sculpt_worker.h"

#include "core/sculpt/sculptor.h"

#include <utility>

namespace app
{
void DocumentJournal::setRecoveryStore(RecoveryStore* recoveryStore)
{
    m_recoveryStore = recoveryStore;
    connect(recoveryStore, &RecoveryStore::noticed, m_document, &Document::noticed);
    connect(recoveryStore, &RecoveryStore::retryDue, this, &DocumentJournal::retryRecording);
    connect(recoveryStore, &RecoveryStore::spaceFound, this, &DocumentJournal::startRecording);
}

void DocumentJournal::begin(LoadedModel& model)
{
    m_recovered = std::exchange(model.recovered, nullptr);
    const auto before =
        std::exchange(m_journal, m_recovered ? m_recoveryStore->resume(model.offer, *m_recovered) : model.journal);
    m_document->history().store().setJournal(m_journal);
    m_document->worker().setModel(std::exchange(model.sculptor, nullptr), m_journal);
    if (m_recoveryStore)
        m_recoveryStore->setPresent(m_journal);
    if (before)
        m_document->worker().post(
            [recoveryStore = m_recoveryStore, before](core::Sculptor&) { recoveryStore->discard(before); });
}

void DocumentJournal::restore()
{
    const auto recovered = std::exchange(m_recovered, nullptr);
    if (!recovered)
        return;
    m_document->history().restore(recovered->history, recovered->deltas);
    m_document->savedState().setModifiedBeyondHistory(recovered->document.changedBeyondHistory);
    m_document->lastStroke().restore();
}

/// Looks for disk space to record the present model again, if nothing is recorded of it.
void DocumentJournal::retryRecording()
{
    const quint64 faces = m_document->modelInfo().faces;
    if (faces > 0 && (!m_journal || m_journal->isBroken()))
        m_recoveryStore->findSpace(faces);
}

/// Begins a new journal with the present model as its base. Does not wait until it is written.
void DocumentJournal::startRecording(const std::shared_ptr<core::JournalFolder>& folder)
{
    m_document->queue().enqueue([this, folder] {
        if (m_journal && !m_journal->isBroken())
            return;
        SculptWorker& worker = m_document->worker();
        if (!worker.strokes().hold()) // another source's stroke is open: waits for its end
            return startRecording(folder);
        const core::BaseRecord base{document(), history()};
        const core::StartRecord start{m_document->changer().start(), base.document};
        m_journal = m_recoveryStore->beginDeferred(folder, base.history.present);
        m_document->history().store().setJournal(m_journal);
        worker.setJournal(m_journal);
        worker.post([journal = m_journal, start, base](core::Sculptor& sculptor) {
            journal->beginWith(ModelChangeJob::copyOf(sculptor.mesh()), start, base);
        });
        worker.strokes().release();
    });
}

core::JournalDocument DocumentJournal::document() const
{
    const ui::ModelInfo& info = m_document->modelInfo();
    return {info.name.toStdString(), info.path.toStdString(), m_document->metadata(),
            m_document->savedState().isModifiedBeyondHistory()};
}

core::JournalHistory DocumentJournal::history() const
{
    const QUndoStack& stack = m_document->history().stack();
    core::JournalHistory history;
    history.saved.reset();
    history.isWhole = m_document->history().isWhole();
    for (int i = 0; i < stack.count(); ++i)
        history.steps.push_back(
            StrokeStep::forJournal(stack.text(i), static_cast<const StrokeCommand*>(stack.command(i))->marks()));
    history.present = static_cast<std::uint32_t>(stack.index());
    if (stack.cleanIndex() >= 0)
        history.saved = static_cast<std::uint32_t>(stack.cleanIndex());
    return history;
}

void DocumentJournal::describe()
{
    if (m_journal && !m_recovered) // the recovered journal already contains the description
        m_journal->describe(document());
}

void DocumentJournal::forget()
{
    if (m_journal)
        m_document->worker().post([journal = m_journal](core::Sculptor&) { journal->forget(); });
    describe();
}
} // namespace app
