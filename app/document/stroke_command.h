#pragma once

#include "app/worker/stroke_step.h"

#include <QUndoCommand>

namespace app
{
class HistoryStore;

/// A stroke, or another finished change of the mesh, in the undo stack. It is already done when it is pushed: the first
/// redo() does nothing.
class StrokeCommand : public QUndoCommand
{
public:
    /// `text` names the step. `index`: its place in the undo stack, and in the store, which must outlive it.
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
