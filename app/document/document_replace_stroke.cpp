// The last stroke, done again by another brush: it is taken back, and another comes in its place.

#include "app/document/document.h"

#include "app/worker/stroke_step.h"

#include <utility>

namespace app
{
std::optional<Document::LastStroke> Document::lastStroke() const
{
    if (!m_lastReport || m_stack.index() != m_stack.count() || m_stack.count() != m_lastIndex + 1 ||
        !m_history.canUndo(m_stack.index()))
        return std::nullopt;
    return LastStroke{*m_lastReport, m_history.at(m_lastIndex), m_lastIndex,
                      isModified() ? std::nullopt : std::optional(m_savings)};
}

/// From the one to the other nobody sculpts, and nobody sees the model without either.
void Document::replaceLastStroke(const LastStroke& last, std::shared_ptr<const core::Stroke> stroke,
                                 const std::stop_token& stop, TakeAgain done)
{
    request([this, last, stroke = std::move(stroke), stop, done = std::move(done)] {
        const bool isLast = m_stack.count() == last.index + 1 && m_stack.index() >= last.index;
        if (!isLast || !m_worker->hold())
            return done(std::nullopt);
        m_takeAgain = [this, last, done](const std::optional<StrokeReport>& report) {
            if (report && report->recordedStep == last.report.recordedStep && last.saving == m_savings)
                setSaved(last.index + 1);
            done(report);
        };
        m_lastStep = StrokeStep::textOf((stroke ? stroke.get() : last.report.stroke())->settings.tool);
        m_worker->hidePatches();
        if (m_stack.index() > last.index)
            comeTo(last.index);
        m_worker->replaceLastStroke(
            {last.report, [change = last.change](core::Sculptor& sculptor) { return change->swap(sculptor); }, stroke,
             stop});
        m_worker->release();
        notifyStateChanged();
    });
}

/// Also where the report came too late, for another model.
void Document::onStrokeReplaced(const StrokeReport& report)
{
    if (!report.isReplacement)
        return;
    const TakeAgain take = std::exchange(m_takeAgain, nullptr);
    take(m_isInstalling ? std::nullopt : std::optional(report));
}
} // namespace app
