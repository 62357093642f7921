// How the document's changes outlive the program, and come back.

#include "document.h"

#include "journal_shelf.h"
#include "model_loader.h"
#include "stroke_command.h"

#include <utility>

namespace app
{
void Document::keepJournals(JournalShelf* shelf)
{
    m_shelf = shelf;
    connect(shelf, &JournalShelf::failed, this, &Document::noticed);
}

void Document::recover(quint64 offer, const QString& name)
{
    openFrom(tr("Recovering %1").arg(name), [shelf = m_shelf, offer](const core::JobWatch& watch) { return shelf->recover(offer, watch); });
}

/// With its journal, which may be none. That of the model before goes when nobody writes to it any more.
void Document::giveWorker(std::shared_ptr<core::Sculptor> sculptor, std::shared_ptr<core::Journal> journal)
{
    const auto before = std::exchange(m_journal, std::move(journal));
    m_history.setJournal(m_journal);
    m_worker->setModel(std::move(sculptor), m_journal);
    if (before)
        m_worker->post([shelf = m_shelf, before](core::Sculptor&) { shelf->discard(before); });
}

/// The undo stack has its steps again, in names and places; the changes are the store's.
void Document::restore(const core::RecoveredDocument& recovered)
{
    const core::JournalHistory& history = recovered.history;
    const QSignalBlocker quiet(m_stack); // of steps that nobody takes
    for (int i = 0; i < static_cast<int>(history.steps.size()); ++i) {
        const core::JournalStep& step = history.steps[static_cast<std::size_t>(i)];
        const StepMarks marks{QString::fromStdString(step.icon), step.dabs, step.fusions};
        m_stack.push(new StrokeCommand(QString::fromStdString(step.text), marks, &m_history, i));
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

void Document::describeToJournal()
{
    if (!m_journal || m_recovered) // or it says already what is to come
        return;
    core::DocumentNotes notes = m_facts.notes;
    if (m_completeNotes)
        m_completeNotes(notes);
    m_journal->describe({m_facts.name.toStdString(), m_facts.path.toStdString(), std::move(notes), m_changedBeyondHistory});
}
} // namespace app
