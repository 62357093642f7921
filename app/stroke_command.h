#pragma once

#include "core/journal/record.h"

#include <QCoreApplication>
#include <QUndoCommand>

namespace app
{
class HistoryStore;
struct StrokeReport;

/// What History shows of a step besides its name, and what did it.
struct StepMarks
{
    QString icon;     ///< of those in resources/icons
    quint64 dabs = 0; ///< 0: it was no stroke
    quint64 fusions = 0;
    std::shared_ptr<const core::FileEntry> deed; ///< null: not known
};

struct StepWords
{
    QString text;
    StepMarks marks;
};

/// A stroke, or another finished change of the mesh, in the undo stack. It is already done when it is pushed: the first
/// redo() does nothing.
class StrokeCommand : public QUndoCommand
{
    Q_DECLARE_TR_FUNCTIONS(app::StrokeCommand)

public:
    /// `text` names the step. `index`: its place in the undo stack, and in the store, which must outlive it.
    StrokeCommand(const QString& text, StepMarks marks, HistoryStore* store, int index);

    const StepMarks& marks() const { return m_marks; }

    void undo() override;
    void redo() override;

    static QString textOf(core::Tool tool);
    static QString iconOf(core::Tool tool);
    /// Of the brush's model, or of a ball.
    static QString textOfAdding(bool isModel);
    /// Any thread.
    static StepWords wordsOf(const StrokeReport& report);
    /// What wordsOf() was made of; nothing if it was no stroke, or cannot be done again without its files.
    static std::optional<StrokeReport> reportOf(const StepMarks& marks);
    static core::JournalStep forJournal(const QString& text, const StepMarks& marks);
    static StepWords fromJournal(const core::JournalStep& step);

private:
    StepMarks m_marks;
    HistoryStore* m_store;
    int m_index;
    bool m_isDone = true;
};
} // namespace app
