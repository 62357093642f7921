#include "app/document/model_changer.h"

#include "app/document/document.h"
#include "app/model/command_names.h"
#include "app/model/model_change_job.h"
#include "app/worker/sculpt_worker.h"

#include "core/journal/journal.h"
#include "core/sculpt/sculptor.h"

#include <QFileInfo>

#include <utility>

namespace app
{
namespace
{
/// Returns the name of the part that the insertion adds; empty if it adds none.
std::string partNameOf(const ui::InsertRequest& insertion)
{
    if (insertion.combination != core::Insert::Combination::Part)
        return {};
    return core::shortened(QFileInfo(insertion.path).completeBaseName().toStdString());
}
} // namespace

void ModelChanger::apply(const core::ModelCommand& command)
{
    applyTo(m_document->parts().active(), command);
}

void ModelChanger::applyTo(core::PartId part, const core::ModelCommand& command)
{
    if (m_document->job().isBusy())
        return Q_EMIT ended(false);
    m_document->queue().enqueue([this, part, command] { start({command, {}, part}); });
}

void ModelChanger::insert(const ui::InsertRequest& insertion)
{
    if (!m_document->job().isBusy())
        m_document->queue().enqueue([this, insertion] {
            start(
                {core::Insert{{}, insertion.place, insertion.centre, insertion.combination, {}, partNameOf(insertion)},
                 insertion, m_document->parts().active()});
        });
}

void ModelChanger::start(ModelChangeRequest request)
{
    BackgroundJob& job = m_document->job();
    if (job.isBusy())
        return Q_EMIT ended(false);
    if (!m_document->queue().hold([this, request] { start(request); }))
        return;
    if (auto* const reset = std::get_if<core::Reset>(&request.command))
        reset->start = m_start;
    m_document->queue().setPause(DocumentQueue::Pause::Changing);
    if (core::isInFrame(request.command))
        return applyInFrame(request);
    const core::JobControl control = job.beginCancellable(CommandNames::progress(request.command));
    m_document->worker().post([this, request = std::move(request), control](core::Sculptor& sculptor) {
        BackgroundJob& work = m_document->job();
        auto run = [&work, copy = ModelChangeJob::copyOf(sculptor.mesh()), request, control] {
            return ModelChangeJob::run(
                copy, request, [&work](const QString& what) { work.rename(what); }, control);
        };
        work.run(std::move(run), [this, request](ModelChangeOutcome outcome) { finish(request, std::move(outcome)); });
    });
}

/// Applies a command that changes no vertex, on the mesh thread and without a copy.
void ModelChanger::applyInFrame(const ModelChangeRequest& request)
{
    BackgroundJob& job = m_document->job();
    job.begin(CommandNames::progress(request.command));
    m_document->worker().post([this, request, &job](core::Sculptor& sculptor) {
        ModelChangeOutcome outcome;
        outcome.change = core::applyInFrame(sculptor.mesh(), request.command, request.part);
        outcome.problem = CommandNames::refusal(outcome.change, {});
        job.run([outcome = std::move(outcome)] { return outcome; },
                [this, request](const ModelChangeOutcome& done) { finish(request, done); });
    });
}

void ModelChanger::finish(const ModelChangeRequest& request, ModelChangeOutcome outcome)
{
    if (m_document->job().wasCancelled() || !outcome.change.changes)
        return end(request, outcome);
    m_document->job().commit();
    auto delta = std::make_shared<core::MeshDelta>(std::move(outcome.change.delta));
    const auto recordedStep = std::make_shared<const core::FileEntry>(
        core::FileCommand{request.command, request.insertion.path.toStdString(), request.part});
    const StepDescription step{
        StrokeStep::textOfPart(m_document->parts().named(request), CommandNames::name(request.command)),
        {CommandNames::icon(request.command), 0, 0, recordedStep}};
    const auto& journal = m_document->journaling().journal();
    m_document->worker().post(
        [delta, record = StrokeStep::forJournal(step.text, step.marks), journal](core::Sculptor& sculptor) {
            sculptor.swap(*delta);
            if (journal)
                journal->changed(sculptor.mesh(), *delta, record);
        });
    m_document->queue().whenRecorded([this, request, outcome = std::move(outcome), delta, step] {
        m_document->history().push(step, delta);
        if (outcome.change.addedPart)
            m_document->parts().activateLast();
        Q_EMIT m_document->stepped(*step.marks.recordedStep);
        end(request, outcome);
    });
}

void ModelChanger::end(const ModelChangeRequest& request, const ModelChangeOutcome& outcome)
{
    BackgroundJob& job = m_document->job();
    m_document->queue().setPause(DocumentQueue::Pause::None);
    m_document->worker().strokes().release();
    job.end();
    if (!job.wasCancelled())
        reportOutcome(request, outcome);
    m_document->notifyStateChanged();
    Q_EMIT ended(!job.wasCancelled() && outcome.change.changes);
    m_document->queue().run();
}

void ModelChanger::reportOutcome(const ModelChangeRequest& request, const ModelChangeOutcome& outcome)
{
    if (std::holds_alternative<core::Insert>(request.command) && outcome.isRepairable && !request.insertion.repair)
        return Q_EMIT insertionRepairable(request.insertion, outcome.problem);
    if (outcome.doubt)
        return Q_EMIT m_document->repairDoubted(*outcome.doubt, [this, insertion = request.insertion]() mutable {
            insertion.acceptsLoss = true;
            insert(insertion);
        });
    if (!outcome.problem.isEmpty())
        return Q_EMIT m_document->refused(outcome.problem);
    if (!outcome.change.changes)
        return Q_EMIT m_document->noticed(CommandNames::unchanged(request.command));
    if (!outcome.notice.isEmpty())
        Q_EMIT m_document->noticed(outcome.notice);
    if (!outcome.repairs.isEmpty())
        Q_EMIT insertedRepaired(QFileInfo(request.insertion.path).fileName(), outcome.repairs);
}
} // namespace app
