#pragma once

#include "core/brush.h"

#include <QCoreApplication>
#include <QUndoCommand>

namespace app
{
class HistoryStore;

/// A stroke, or another finished change of the mesh, in the undo stack. It is already done when it is pushed: the first
/// redo() does nothing.
class StrokeCommand : public QUndoCommand
{
    Q_DECLARE_TR_FUNCTIONS(app::StrokeCommand)

public:
    /// `text` names the step. `index`: its place in the undo stack, and in the store, which must outlive it.
    StrokeCommand(const QString& text, HistoryStore* store, int index);

    void undo() override;
    void redo() override;

    static QString textOf(core::Tool tool);

private:
    HistoryStore* m_store;
    int m_index;
    bool m_isDone = true;
};
} // namespace app
