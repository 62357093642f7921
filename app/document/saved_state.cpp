#include "app/document/saved_state.h"

#include "app/document/document.h"

#include "core/journal/journal.h"

#include <utility>

namespace app
{
bool SavedState::isModified() const
{
    return m_isModifiedBeyondHistory || !m_document->history().stack().isClean() || m_document->queue().hasUnreported();
}

void SavedState::setSaved(int index)
{
    if (m_document->history().stack().index() != index || m_document->queue().hasUnreported())
        return;
    m_document->history().setClean();
    ++m_count;
    m_isModifiedBeyondHistory = false;
    if (const auto& journal = m_document->journaling().journal())
        journal->saved(static_cast<std::uint32_t>(index));
}

void SavedState::onFileDeleted()
{
    m_isModifiedBeyondHistory = true;
    m_document->journaling().describe();
    m_document->notifyStateChanged();
}

void SavedState::emitIfChanged()
{
    if (!m_document->queue().isMoving() && std::exchange(m_wasModified, isModified()) != isModified())
        Q_EMIT modifiedChanged(m_wasModified);
}
} // namespace app
