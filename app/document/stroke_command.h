#pragma once

#include "app/worker/stroke_step.h"

#include <QUndoCommand>

namespace app
{
class HistoryStore;

/// An undo step: a stroke or another finished change of the mesh. The change is already applied when the command is
/// pushed, so the first redo() does nothing.
class StrokeCommand : public QUndoCommand
{
public:
    /// `text`: name of the step. `index`: its index in the undo stack and in the store. The store must outlive the
    /// command.
    StrokeCommand(const QString& text, StepMarks marks, HistoryStore* store, int index);

    const StepMarks& marks() const { return m_marks; }

    void undo() override;
    void redo() override;

private:
    StepMarks m_marks;
    HistoryStore* m_store;
    int m_index;
    bool m_isDone = true;
};
} // namespace app
