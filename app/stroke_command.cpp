#include "stroke_command.h"

#include "history_store.h"

namespace app
{
StrokeCommand::StrokeCommand(const QString& text, HistoryStore* store, int index)
    : QUndoCommand(text), m_store(store), m_index(index)
{
}

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

QString StrokeCommand::textOf(core::Tool tool)
{
    switch (tool) {
    case core::Tool::Pull: return tr("Pull", "undo step");
    case core::Tool::Push: return tr("Push", "undo step");
    case core::Tool::Flatten: return tr("Flatten", "undo step");
    case core::Tool::Smooth: return tr("Smooth", "undo step");
    case core::Tool::Paint: return tr("Paint", "undo step");
    }
    return {};
}
} // namespace app
