#include "app/document/document_strokes.h"

#include "app/document/document.h"
#include "app/worker/sculpt_worker.h"

#include "ui/util/error_messages.h"
#include "ui/util/part_name.h"

namespace app
{
DocumentStrokes::DocumentStrokes(Document* document) : m_document(document)
{
    connect(&document->worker(), &SculptWorker::strokeFinished, this, &DocumentStrokes::onReport);
}

void DocumentStrokes::beginStroke(const core::StrokeSettings& settings)
{
    reportUneditable();
    DocumentQueue& queue = m_document->queue();
    queue.beginStroke();
    m_document->history().setStrokeText(StrokeStep::textOf(settings.tool));
    queue.enqueueStroke([this, settings] { m_document->worker().strokes().beginStroke(Source::Desktop, settings); });
    m_document->notifyStateChanged();
}

/// Says why the stroke will have no effect if the active part is hidden or locked.
void DocumentStrokes::reportUneditable()
{
    const core::Part* part = m_document->parts().list().find(m_document->parts().active());
    if (part && !part->isVisible)
        Q_EMIT m_document->noticed(tr("%1 is hidden. Show it, or choose another part.").arg(ui::partName(*part)));
    else if (part && part->isLocked)
        Q_EMIT m_document->noticed(tr("%1 is locked. Unlock it, or choose another part.").arg(ui::partName(*part)));
}

void DocumentStrokes::addSample(const core::StrokeSample& sample)
{
    m_document->queue().enqueueStroke(
        [this, sample] { m_document->worker().strokes().addSample(Source::Desktop, sample); });
}

void DocumentStrokes::endStroke(core::StrokeEnd how)
{
    m_document->queue().enqueueStroke([this, how] { m_document->worker().strokes().endStroke(Source::Desktop, how); });
    m_document->queue().endStroke();
}

void DocumentStrokes::addSphere(const core::StrokeSettings& settings, const core::StrokeSample& sample)
{
    m_document->history().setStrokeText(StrokeStep::textOfAdding(settings.model != nullptr));
    m_document->queue().enqueueStroke(
        [this, settings, sample] { m_document->worker().strokes().addSphere(Source::Desktop, settings, sample); });
    m_document->notifyStateChanged();
}

void DocumentStrokes::onReport(const StrokeReport& report)
{
    DocumentQueue& queue = m_document->queue();
    queue.countReport();
    const bool isOther = queue.isPaused(DocumentQueue::Pause::Installing);
    if (!isOther) {
        if (report.delta)
            addStep(report);
        reportShortfall(report);
        m_document->takeFacts(report.facts);
        m_document->journaling().describe();
    }
    m_document->lastStroke().onReport(report, isOther);
    m_document->notifyStateChanged();
    queue.run();
}

void DocumentStrokes::addStep(const StrokeReport& report)
{
    m_document->history().push(StrokeStep::descriptionOf(report), report.delta);
    m_document->lastStroke().setReport(report);
    if (!report.isReplacement)
        m_document->countStroke();
    Q_EMIT m_document->stepped(*report.recordedStep);
}

void DocumentStrokes::reportShortfall(const StrokeReport& report)
{
    // other dabs of the stroke had an effect, so nothing needs to be reported
    const bool isSeen = report.shortfall == core::Shortfall::Blocked && report.delta;
    if (report.shortfall != core::Shortfall::None && !isSeen)
        Q_EMIT m_document->noticed(ui::ErrorMessages::shortfall(report.shortfall));
    else if (report.asymmetric)
        Q_EMIT m_document->noticed(ui::ErrorMessages::asymmetric());
    else if (report.sequential)
        Q_EMIT m_document->noticed(ui::ErrorMessages::sequentialSectors());
}
} // namespace app
