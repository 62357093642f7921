#include "app/document/history_scrubber.h"

#include "app/document/document.h"

#include <algorithm>

namespace app
{
namespace
{
constexpr int stepsAtATime = 8; ///< of strokes, some ms
} // namespace

HistoryScrubber::HistoryScrubber(Document* document) : QObject(document), m_document(document)
{
    connect(document, &Document::historyChanged, this, &HistoryScrubber::goOn);
    connect(document, &Document::opened, this, [this] { m_wanted.reset(); });
}

void HistoryScrubber::want(int state)
{
    if (!m_wanted)
        m_from = m_document->undoStack().index();
    m_wanted = state;
    goOn();
}

void HistoryScrubber::goOn()
{
    if (!m_wanted || !m_document->isSettled())
        return;
    const int present = m_document->undoStack().index();
    const int wanted = std::clamp(*m_wanted, m_document->history().firstIndex(), m_document->history().lastIndex());
    if (present != m_from || present == wanted) // there, or somebody else went elsewhere
        return m_wanted.reset();
    m_from = std::clamp(wanted, present - stepsAtATime, present + stepsAtATime);
    m_document->goTo(m_from);
}
} // namespace app
