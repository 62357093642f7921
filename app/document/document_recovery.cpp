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
void Document::keepJournals(JournalShelf* shelf)
{
    m_shelf = shelf;
    connect(shelf, &JournalShelf::told, this, &Document::noticed);
    connect(shelf, &JournalShelf::mayRecord, this, &Document::wantJournal);
    connect(shelf, &JournalShelf::roomFound, this, &Document::recordLate);
}

void Document::recover(quint64 offer, const QString& name)
{
    openFrom({tr("Recovering %1").arg(name),
              [shelf = m_shelf, offer](const core::JobControl& control) { return shelf->recover(offer, control); }});
}

/// With its journal, which may be none. That of the model before goes when nobody writes to it any more.
void Document::giveWorker(std::shared_ptr<core::Sculptor> sculptor, std::shared_ptr<core::Journal> journal)
{
    const auto before = std::exchange(m_journal, std::move(journal));
    m_history.setJournal(m_journal);
    m_worker->setModel(std::move(sculptor), m_journal);
    if (m_shelf)
        m_shelf->setPresent(m_journal);
    if (before)
        m_worker->post([shelf = m_shelf, before](core::Sculptor&) { shelf->discard(before); });
}

/// The undo stack has its steps again, in names and places; the changes are the store's.
void Document::restore(const core::RecoveredDocument& recovered)
{
    const core::JournalHistory& history = recovered.history;
    const QSignalBlocker quiet(m_stack); // of steps that nobody takes
    for (int i = 0; i < static_cast<int>(history.steps.size()); ++i) {
        const StepWords step = StrokeStep::fromJournal(history.steps[static_cast<std::size_t>(i)]);
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
void Document::wantJournal()
{
    if (m_facts.faces > 0 && (!m_journal || m_journal->isBroken()))
        m_shelf->findRoom(m_facts.faces);
}

/// From here on, on top of the model as it is: nobody waits for that to be written.
void Document::recordLate(const std::shared_ptr<core::JournalFolder>& folder)
{
    request([this, folder] {
        if (m_journal && !m_journal->isBroken())
            return;
        if (!m_worker->hold()) // another hand sculpts
            return recordLate(folder);
        const core::BaseRecord base{forJournal(), historyNow()};
        const core::StartRecord start{m_start, base.document};
        m_journal = m_shelf->beginDeferred(folder, base.history.present);
        m_history.setJournal(m_journal);
        m_worker->setJournal(m_journal);
        m_worker->post([journal = m_journal, start, base](core::Sculptor& sculptor) {
            journal->beginWith(ModelTrial::copyOf(sculptor.mesh()), start, base);
        });
        m_worker->release();
    });
}

core::JournalDocument Document::forJournal() const
{
    return {m_facts.name.toStdString(), m_facts.path.toStdString(), notesNow(), m_changedBeyondHistory};
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
std::optional<std::vector<core::FileEntry>> Document::deedsNow() const
{
    std::vector<core::FileEntry> deeds;
    for (int i = 0; i < m_stack.index(); ++i) {
        const auto& deed = static_cast<const StrokeCommand*>(m_stack.command(i))->marks().deed;
        if (!deed)
            return std::nullopt;
        deeds.push_back(*deed);
    }
    return m_isHistoryWhole ? std::optional(std::move(deeds)) : std::nullopt;
}

void Document::describeToJournal()
{
    if (m_journal && !m_recovered) // or it says already what is to come
        m_journal->describe(forJournal());
}
} // namespace app
