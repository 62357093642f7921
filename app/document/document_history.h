#pragma once

#include "app/document/history_store.h"
#include "app/worker/stroke_step.h"

#include <QUndoStack>

namespace app
{
class DocumentQueue;
class SculptWorker;

/// The steps of a document: the undo stack and the changes behind it. Undo, redo and jumps are requests: they wait for
/// the strokes before them. Thread: gui.
class DocumentHistory : public QObject
{
    Q_OBJECT

public:
    /// None is owned; both must outlive the history.
    DocumentHistory(SculptWorker* worker, DocumentQueue* queue);

    const QUndoStack& stack() const { return m_stack; }
    HistoryStore& store() { return m_store; }
    /// The answer for actions, wands and the history panel: there is a step back, and its change is still kept.
    bool canUndo() const;
    bool canRedo() const;
    QString undoText() const; ///< empty if there is none
    QString redoText() const;
    /// The first step was done to the model as it was opened.
    bool isWhole() const { return m_isWhole; }

    /// The name of the stroke that began last: what undo() would take back before it is reported.
    void setStrokeText(const QString& text) { m_strokeText = text; }
    /// Adds a change that is already done.
    void push(const StepDescription& step, const std::shared_ptr<core::MeshDelta>& delta);
    /// Precondition: the worker is held, and the index is kept.
    void moveTo(int index);
    void setClean() { m_stack.setClean(); }
    void clear(bool isWhole);
    /// Steps of a document that was recovered, with their changes.
    void restore(const core::JournalHistory& history, const std::vector<std::shared_ptr<core::MeshDelta>>& deltas);

public Q_SLOTS:
    void undo();
    void redo();
    void goTo(int index);

Q_SIGNALS:
    /// A move is confirmed.
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
