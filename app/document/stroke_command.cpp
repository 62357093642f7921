#include "app/document/stroke_command.h"

#include "app/document/history_store.h"

namespace app
{
StrokeCommand::StrokeCommand(const QString& text, StepMarks marks, HistoryStore* store, int index)
    : QUndoCommand(text)
    , m_marks(std::move(marks))
    , m_store(store)
    , m_index(index)
{}

void StrokeCommand::undo()
{
    m_store->swap(m_index);
    m_isDone = false;
}

void StrokeCommand::redo()
{
    if (!m_isDone)
        m_store->swap(m_index);
    m_isDone = true;
}
} // namespace app
