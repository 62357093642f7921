#pragma once

#include "app/document/history_store.h"
#include "app/worker/stroke_step.h"

#include <QUndoStack>

namespace app
{
class DocumentQueue;
class SculptWorker;

/// The undo stack of a document and the mesh changes behind it. Undo, redo and jumps are requests that wait for earlier
/// strokes. Thread: gui.
class DocumentHistory : public QObject
{
    Q_OBJECT

public:
    /// Owns neither object; both must outlive the history.
    DocumentHistory(SculptWorker* worker, DocumentQueue* queue);

    const QUndoStack& stack() const { return m_stack; }
    HistoryStore& store() { return m_store; }
    /// Returns whether undo() has an effect: a stroke is open or not reported yet, or there is a step whose change has
    /// not expired.
    bool canUndo() const;
    bool canRedo() const;
    QString undoText() const; ///< empty if nothing can be undone
    QString redoText() const;
    /// Returns whether the stack contains every step since the model was opened.
    bool isWhole() const { return m_isWhole; }

    /// Sets the name of the latest stroke, which undo() would undo before the stroke is reported.
    void setStrokeText(const QString& text) { m_strokeText = text; }
    /// Adds a step whose change is already applied.
    void push(const StepDescription& step, const std::shared_ptr<core::MeshDelta>& delta);
    /// Moves to a step. Precondition: strokes are held, and the step at `index` is still stored.
    void moveTo(int index);
    void setClean() { m_stack.setClean(); }
    void clear(bool isWhole);
    /// Restores the steps and changes of a recovered document.
    void restore(const core::JournalHistory& history, const std::vector<std::shared_ptr<core::MeshDelta>>& deltas);

public Q_SLOTS:
    void undo();
    void redo();
    void goTo(int index);

Q_SIGNALS:
    /// Emitted when a move along the undo stack is confirmed.
    void moved();

private:
    void holdAndMoveTo(int index);

    SculptWorker* m_worker;
    DocumentQueue* m_queue;
    HistoryStore m_store;
    QUndoStack m_stack;
    QString m_strokeText;
    bool m_isWhole = true;
};
} // namespace app
