#include "app/document/history_scrubber.h"

#include "app/document/document.h"

#include <algorithm>

namespace app
{
namespace
{
constexpr int stepsPerMove = 8; ///< most steps undone or redone at once; takes a few ms for strokes
} // namespace

HistoryScrubber::HistoryScrubber(Document* document) : QObject(document), m_document(document)
{
    connect(document, &Document::historyChanged, this, &HistoryScrubber::proceed);
    connect(document, &Document::opened, this, [this] { m_target.reset(); });
}

void HistoryScrubber::scrubTo(int state)
{
    if (!m_target)
        m_from = m_document->history().stack().index();
    m_target = state;
    proceed();
}

void HistoryScrubber::proceed()
{
    if (!m_target || !m_document->queue().isSettled())
        return;
    const int present = m_document->history().stack().index();
    const int target =
        std::clamp(*m_target, m_document->history().store().firstIndex(), m_document->history().store().lastIndex());
    if (present != m_from || present == target) // arrived, or something else moved along the undo stack
        return m_target.reset();
    m_from = std::clamp(target, present - stepsPerMove, present + stepsPerMove);
    m_document->history().goTo(m_from);
}
} // namespace app
