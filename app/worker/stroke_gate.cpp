#include "app/worker/stroke_gate.h"

#include <utility>

namespace app
{
bool StrokeGate::beginStroke(Source source, const core::StrokeSettings& settings)
{
    return begin({settings, source});
}

bool StrokeGate::begin(const BeginStroke& stroke)
{
    {
        const std::lock_guard lock(m_mutex);
        if (!m_openSource && !m_isHeld) {
            m_openSource = stroke.source;
            ++m_begun;
            m_queue->push(stroke);
            return true;
        }
    }
    Q_EMIT refused(stroke.source);
    return false;
}

void StrokeGate::addSample(Source source, const core::StrokeSample& sample)
{
    const std::lock_guard lock(m_mutex);
    if (m_openSource == source)
        m_queue->push(Sample{sample, steadyNs()});
}

void StrokeGate::endStroke(Source source, core::StrokeEnd how)
{
    const std::lock_guard lock(m_mutex);
    if (m_openSource != source)
        return;
    m_openSource.reset();
    m_queue->push(EndStroke{how});
}

bool StrokeGate::addSphere(Source source, const core::StrokeSettings& settings, const core::StrokeSample& sample)
{
    if (!begin({settings, source, true}))
        return false;
    addSample(source, sample);
    endStroke(source);
    return true;
}

bool StrokeGate::hold()
{
    const std::lock_guard lock(m_mutex);
    m_isHeld = !m_openSource;
    return m_isHeld;
}

void StrokeGate::release()
{
    const std::lock_guard lock(m_mutex);
    m_isHeld = false;
}

void StrokeGate::pushAfterStroke(Task task)
{
    const std::lock_guard lock(m_mutex);
    if (std::exchange(m_openSource, std::nullopt))
        m_queue->push(EndStroke{});
    m_queue->push(std::move(task));
}

bool StrokeGate::isOpen() const
{
    const std::lock_guard lock(m_mutex);
    return m_openSource.has_value();
}
} // namespace app
