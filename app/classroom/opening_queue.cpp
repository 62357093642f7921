#include "app/classroom/opening_queue.h"

#include "app/document/document.h"

#include <utility>

namespace app
{
OpeningQueue::OpeningQueue(Document* document) : m_document(document)
{
    connect(document, &Document::opened, this, [this] { m_isOpened = true; });
    connect(document, &Document::opened, this, &OpeningQueue::proceed, Qt::QueuedConnection);
    connect(&document->job(), &BackgroundJob::idle, this, &OpeningQueue::checkIdle, Qt::QueuedConnection);
}

void OpeningQueue::openThen(const std::function<void()>& open, const std::function<void()>& then)
{
    if (m_then) {
        m_then = [this, open, then] { openThen(open, then); };
        return;
    }
    m_then = then;
    open();
}

void OpeningQueue::proceed()
{
    m_isOpened = false;
    if (const auto then = std::exchange(m_then, nullptr))
        then();
}

void OpeningQueue::checkIdle()
{
    if (!m_isOpened && !m_document->job().isBusy() && std::exchange(m_then, nullptr))
        Q_EMIT failed();
}
} // namespace app
