#include "app/document/last_stroke.h"

#include "app/document/document.h"
#include "app/document/stroke_command.h"
#include "app/worker/sculpt_worker.h"

#include <utility>

namespace app
{
std::optional<LastStroke::Step> LastStroke::step() const
{
    DocumentHistory& history = m_document->history();
    const int count = history.stack().count();
    if (!m_report || count == 0 || history.stack().index() != count || !history.store().canUndo(count))
        return std::nullopt;
    const auto* command = static_cast<const StrokeCommand*>(history.stack().command(count - 1));
    if (command->marks().recordedStep != m_report->recordedStep)
        return std::nullopt;
    const SavedState& saved = m_document->savedState();
    return Step{*m_report, history.store().at(count - 1), count - 1,
                saved.isModified() ? std::nullopt : std::optional(saved.count())};
}

void LastStroke::replace(const Step& last, std::shared_ptr<const core::Stroke> stroke, const std::stop_token& stop,
                         Done done)
{
    m_document->queue().enqueue([this, last, stroke = std::move(stroke), stop, done = std::move(done)] {
        DocumentHistory& history = m_document->history();
        SculptWorker& worker = m_document->worker();
        const bool isLast = history.stack().count() == last.index + 1 && history.stack().index() >= last.index;
        if (!isLast || !worker.strokes().hold())
            return done(std::nullopt);
        m_done = [this, last, done](const std::optional<StrokeReport>& report) {
            if (report && report->recordedStep == last.report.recordedStep &&
                last.saving == m_document->savedState().count())
                m_document->savedState().setSaved(last.index + 1);
            done(report);
        };
        history.setStrokeText(StrokeStep::textOf((stroke ? stroke.get() : last.report.stroke())->settings.tool));
        worker.hidePatches();
        if (history.stack().index() > last.index)
            history.moveTo(last.index);
        worker.replaceLastStroke({last.report,
                                  [change = last.change](core::Sculptor& sculptor) { return change->swap(sculptor); },
                                  stroke, stop});
        worker.strokes().release();
        m_document->notifyStateChanged();
    });
}

void LastStroke::setReport(const StrokeReport& report)
{
    m_report = report;
    m_report->delta = nullptr;
}

void LastStroke::onReport(const StrokeReport& report, bool isOther)
{
    if (!report.isReplacement)
        return;
    const Done done = std::exchange(m_done, nullptr);
    done(isOther ? std::nullopt : std::optional(report));
}

void LastStroke::restore()
{
    const QUndoStack& stack = m_document->history().stack();
    if (stack.count() > 0)
        m_report = StrokeStep::reportOf(static_cast<const StrokeCommand*>(stack.command(stack.count() - 1))->marks());
}
} // namespace app
