#include "app/document/model_changer.h"

#include "app/document/document.h"
#include "app/model/command_names.h"
#include "app/model/model_change_job.h"
#include "app/worker/sculpt_worker.h"

#include "core/journal/journal.h"
#include "core/operations/detached_part.h"
#include "core/parts/part_split.h"
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

/// Returns the name of the step: with the name of the part, if the request changes one of several.
QString textOf(const ModelChangeRequest& request, const DocumentParts& parts)
{
    const auto* const show = std::get_if<core::ShowParts>(&request.command);
    const auto switched = show ? parts.switchedBy(*show) : std::nullopt;
    if (switched)
        return StrokeStep::textOfPart(switched, CommandNames::switching(!switched->isVisible));
    return StrokeStep::textOfPart(parts.named(request), CommandNames::name(request.command));
}

/// Returns the parts of which the request takes something away.
std::shared_ptr<const core::DrawArrays> translucentOf(const core::Mesh& mesh, const ModelChangeRequest& request)
{
    const auto& command = std::get<core::CombineParts>(request.command);
    std::vector<core::PartId> parts;
    if (command.operation != core::SetOperation::Union)
        parts = command.others;
    if (command.operation == core::SetOperation::Intersection)
        parts.push_back(request.part);
    std::vector<core::PartPiece> pieces;
    for (const core::PartId part : parts)
        pieces.push_back({part, core::surfaceOf(mesh, part), {}, {}});
    if (pieces.empty())
        return {};
    core::TriangleMesh translucent = core::joined(pieces);
    translucent.colors.clear();
    return std::make_shared<const core::DrawArrays>(core::drawArraysOf(translucent));
}
} // namespace

struct ModelChanger::Change
{
    ModelChangeRequest request;
    ModelChangeOutcome outcome; ///< without its delta
    std::shared_ptr<core::MeshDelta> delta;
    StepDescription step;
};

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

void ModelChanger::preview(core::PartId part, const core::CombineParts& command)
{
    if (!m_document->job().isBusy())
        m_document->queue().enqueue([this, part, command] { start({command, {}, part, true}); });
}

void ModelChanger::previewInstead(core::SetOperation operation)
{
    if (!m_preview)
        return;
    ModelChangeRequest request = m_preview->request;
    std::get<core::CombineParts>(request.command).operation = operation;
    takeBack();
    Q_EMIT previewTakenBack();
    compute(request);
}

void ModelChanger::applyPreview()
{
    if (!m_preview)
        return;
    m_document->job().commit();
    record(std::exchange(m_preview, nullptr));
}

void ModelChanger::dropPreview()
{
    if (!m_isPreviewing)
        return;
    m_document->job().cancel();
    if (const auto change = m_preview) { // otherwise finish() ends it
        takeBack();
        end(change->request, change->outcome);
    }
}

void ModelChanger::takeBack()
{
    m_document->worker().post(
        [delta = std::exchange(m_preview, nullptr)->delta](core::Sculptor& sculptor) { sculptor.swap(*delta); });
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
    compute(request);
}

/// Computes the change on a copy of the mesh in another thread.
void ModelChanger::compute(const ModelChangeRequest& request)
{
    m_isPreviewing = request.isPreview;
    const core::JobControl control = m_document->job().beginCancellable(CommandNames::progress(request.command));
    m_document->worker().post([this, request, control](core::Sculptor& sculptor) {
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
        outcome.notice = CommandNames::shortening(request.command);
        job.run([outcome = std::move(outcome)] { return outcome; },
                [this, request](const ModelChangeOutcome& done) { finish(request, done); });
    });
}

void ModelChanger::finish(const ModelChangeRequest& request, ModelChangeOutcome outcome)
{
    if (m_document->job().wasCancelled() || !outcome.change.changes)
        return end(request, outcome);
    auto delta = std::make_shared<core::MeshDelta>(std::move(outcome.change.delta));
    const auto recordedStep = std::make_shared<const core::FileEntry>(
        core::FileCommand{request.command, request.insertion.path.toStdString(), request.part});
    StepDescription step{textOf(request, m_document->parts()),
                         {CommandNames::icon(request.command), 0, 0, recordedStep}};
    const auto change =
        std::make_shared<const Change>(Change{request, std::move(outcome), std::move(delta), std::move(step)});
    if (request.isPreview)
        return show(change);
    m_document->job().commit();
    m_document->worker().post([delta = change->delta](core::Sculptor& sculptor) { sculptor.swap(*delta); });
    record(change);
}

void ModelChanger::show(const std::shared_ptr<const Change>& change)
{
    m_preview = change;
    Q_EMIT m_document->job().busy(tr("Preview: %1").arg(change->step.text));
    m_document->worker().post([this, change](core::Sculptor& sculptor) {
        const auto operation = std::get<core::CombineParts>(change->request.command).operation;
        const auto translucent = translucentOf(sculptor.mesh(), change->request);
        sculptor.swap(*change->delta);
        m_mailbox.post([this, change, operation, translucent] {
            if (m_preview == change)
                Q_EMIT previewed(operation, translucent);
        });
    });
    m_document->notifyStateChanged(); // the mesh has changed; a window that is closing drops the preview
}

/// Records a change that the mesh has, and makes it a step.
void ModelChanger::record(const std::shared_ptr<const Change>& change)
{
    m_document->worker().post([change, step = StrokeStep::forJournal(change->step.text, change->step.marks),
                               journal = m_document->journaling().journal()](core::Sculptor& sculptor) {
        if (journal)
            journal->changed(sculptor.mesh(), *change->delta, step);
    });
    m_document->queue().whenRecorded([this, change] {
        m_document->history().push(change->step, change->delta);
        if (const auto added = change->outcome.change.addedPart)
            m_document->parts().activate(*added);
        Q_EMIT m_document->stepped(*change->step.marks.recordedStep);
        end(change->request, change->outcome);
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
    if (std::exchange(m_isPreviewing, false))
        Q_EMIT previewEnded();
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
