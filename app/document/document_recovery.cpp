// How the document's changes outlive the program, and come back.

#include "app/document/document.h"

#include "app/document/stroke_command.h"
#include "app/model/model_change_job.h"
#include "app/model/model_loader.h"
#include "app/recovery/recovery_store.h"
#include "app/worker/stroke_step.h"

#include <utility>

namespace app
{
void Document::keepJournals(RecoveryStore* recoveryStore)
{
    m_recoveryStore = recoveryStore;
    connect(recoveryStore, &RecoveryStore::noticed, this, &Document::noticed);
    connect(recoveryStore, &RecoveryStore::retryDue, this, &Document::retryRecording);
    connect(recoveryStore, &RecoveryStore::spaceFound, this, &Document::startRecording);
}

void Document::recover(quint64 offer, const QString& name)
{
    openFrom({tr("Recovering %1").arg(name), [recoveryStore = m_recoveryStore, offer](const core::JobControl& control) {
                  return recoveryStore->recover(offer, control);
              }});
}

/// With its journal, which may be none. That of the model before goes when nobody writes to it any more.
void Document::giveWorker(std::shared_ptr<core::Sculptor> sculptor, std::shared_ptr<core::Journal> journal)
{
    const auto before = std::exchange(m_journal, std::move(journal));
    m_history.setJournal(m_journal);
    m_worker->setModel(std::move(sculptor), m_journal);
    if (m_recoveryStore)
        m_recoveryStore->setPresent(m_journal);
    if (before)
        m_worker->post([recoveryStore = m_recoveryStore, before](core::Sculptor&) { recoveryStore->discard(before); });
}

/// The undo stack has its steps again, in names and places; the changes are the store's.
void Document::restore(const core::RecoveredDocument& recovered)
{
    const core::JournalHistory& history = recovered.history;
    const QSignalBlocker quiet(m_stack); // of steps that nobody takes
    for (int i = 0; i < static_cast<int>(history.steps.size()); ++i) {
        const StepDescription step = StrokeStep::fromJournal(history.steps[static_cast<std::size_t>(i)]);
        m_stack.push(new StrokeCommand(step.text, step.marks, &m_history, i));
    }
    m_isHistoryWhole = history.isWhole;
    if (m_stack.count() > 0) {
        m_lastIndex = m_stack.count() - 1;
        m_lastReport = StrokeStep::reportOf(static_cast<const StrokeCommand*>(m_stack.command(m_lastIndex))->marks());
    }
    m_stack.resetClean();
    if (history.saved && static_cast<int>(*history.saved) <= m_stack.count()) {
        m_stack.setIndex(static_cast<int>(*history.saved));
        m_stack.setClean();
    }
    m_stack.setIndex(static_cast<int>(history.present));
    m_changedBeyondHistory = recovered.document.changedBeyondHistory;
    m_history.restore(recovered.deltas, static_cast<int>(history.present));
}

/// Nothing is recorded of the model that is open, and that may be possible again.
void Document::retryRecording()
{
    if (m_modelInfo.faces > 0 && (!m_journal || m_journal->isBroken()))
        m_recoveryStore->findSpace(m_modelInfo.faces);
}

/// From here on, on top of the model as it is: nobody waits for that to be written.
void Document::startRecording(const std::shared_ptr<core::JournalFolder>& folder)
{
    request([this, folder] {
        if (m_journal && !m_journal->isBroken())
            return;
        if (!m_worker->hold()) // another hand sculpts
            return startRecording(folder);
        const core::BaseRecord base{forJournal(), historyNow()};
        const core::StartRecord start{m_start, base.document};
        m_journal = m_recoveryStore->beginDeferred(folder, base.history.present);
        m_history.setJournal(m_journal);
        m_worker->setJournal(m_journal);
        m_worker->post([journal = m_journal, start, base](core::Sculptor& sculptor) {
            journal->beginWith(ModelChangeJob::copyOf(sculptor.mesh()), start, base);
        });
        m_worker->release();
    });
}

core::JournalDocument Document::forJournal() const
{
    return {m_modelInfo.name.toStdString(), m_modelInfo.path.toStdString(), presentMetadata(), m_changedBeyondHistory};
}

core::JournalHistory Document::historyNow() const
{
    core::JournalHistory history;
    history.saved.reset();
    history.isWhole = m_isHistoryWhole;
    for (int i = 0; i < m_stack.count(); ++i)
        history.steps.push_back(
            StrokeStep::forJournal(m_stack.text(i), static_cast<const StrokeCommand*>(m_stack.command(i))->marks()));
    history.present = static_cast<std::uint32_t>(m_stack.index());
    if (m_stack.cleanIndex() >= 0)
        history.saved = static_cast<std::uint32_t>(m_stack.cleanIndex());
    return history;
}

/// Nothing if that of one step is not known.
std::optional<std::vector<core::FileEntry>> Document::recordedSteps() const
{
    std::vector<core::FileEntry> steps;
    for (int i = 0; i < m_stack.index(); ++i) {
        const auto& recordedStep = static_cast<const StrokeCommand*>(m_stack.command(i))->marks().recordedStep;
        if (!recordedStep)
            return std::nullopt;
        steps.push_back(*recordedStep);
    }
    return m_isHistoryWhole ? std::optional(std::move(steps)) : std::nullopt;
}

void Document::describeToJournal()
{
    if (m_journal && !m_recovered) // or it says already what is to come
        m_journal->describe(forJournal());
}
} // namespace app
