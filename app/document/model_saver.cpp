#include "app/document/model_saver.h"

#include "app/document/document.h"
#include "app/document/stroke_command.h"
#include "app/model/brush_export.h"
#include "app/model/model_change_job.h"
#include "app/model/model_export.h"
#include "app/model/model_saving.h"
#include "app/worker/sculpt_worker.h"

#include "core/mesh/mesh_builder.h"
#include "core/sculpt/sculptor.h"
#include "ui/settings/settings.h"

#include <QFileInfo>

#include <utility>

namespace app
{
void ModelSaver::save(const QString& path)
{
    const int backups = ui::Settings().get<ui::Preferences>().keepsBackups ? ui::backupCount : 0;
    saveBy(QFileInfo(path).fileName(),
           [path, backups](const core::TriangleMesh& mesh, const core::DocumentMetadata& metadata) {
               return ModelSaving::save(path, mesh, metadata, backups);
           });
}

void ModelSaver::saveNumbered(const QString& path)
{
    saveBy(m_document->modelInfo().name,
           [path](const core::TriangleMesh& mesh, const core::DocumentMetadata& metadata) {
               return ModelSaving::saveNumbered(path, mesh, metadata);
           });
}

void ModelSaver::saveBy(const QString& name, const Write& write)
{
    BackgroundJob& job = m_document->job();
    if (job.isBusy())
        return;
    job.begin(tr("Saving %1").arg(name));
    m_document->queue().enqueue([this, write] {
        const int index = m_document->history().stack().index();
        m_document->worker().post([this, write, metadata = m_document->metadata(),
                                   index](core::Sculptor& sculptor) mutable {
            metadata.frame = sculptor.mesh().frame();
            auto mesh = std::make_shared<core::TriangleMesh>(core::extractMesh(sculptor.mesh()));
            auto work = [write, metadata, mesh = std::move(mesh)] { return write(*mesh, metadata); };
            m_document->job().run(std::move(work), [this, index](const SavedFile& file) { finishSaving(index, file); });
        });
    });
}

/// Marks undo state `index` as saved. If further steps were made meanwhile, the model stays modified.
void ModelSaver::finishSaving(int index, const SavedFile& file)
{
    m_document->job().end();
    if (!file.problem.isEmpty()) {
        Q_EMIT m_document->refused(file.problem);
        Q_EMIT saveFailed(file.path);
        return;
    }
    m_document->setFile(file.path);
    m_document->savedState().setSaved(index);
    Q_EMIT saved(file.path);
    m_document->notifyStateChanged();
    if (!file.notice.isEmpty())
        Q_EMIT m_document->noticed(file.notice);
}

void ModelSaver::exportTo(const QString& path, const ui::ExportSettings& options)
{
    BackgroundJob& job = m_document->job();
    if (job.isBusy())
        return;
    const core::JobControl control = job.beginCancellable(tr("Exporting %1").arg(QFileInfo(path).fileName()));
    m_document->queue().enqueue([this, path, options, control] {
        ExportRequest asked{path, options.maxTriangles, options.slices, m_document->metadata(), {}, options.joinsParts};
        m_document->worker().post([this, request = std::move(asked), control](core::Sculptor& sculptor) mutable {
            BackgroundJob& work = m_document->job();
            request.mesh = ModelChangeJob::copyOf(sculptor.mesh());
            request.metadata.frame = sculptor.mesh().frame();
            work.run(
                [request, &work, control] {
                    return ModelExport::run(
                        request, [&work](const QString& what) { work.rename(what); }, control);
                },
                [this, path = request.path](const ExportOutcome& outcome) { finishExport(path, outcome); });
        });
    });
}

void ModelSaver::finishExport(const QString& path, const ExportOutcome& outcome)
{
    m_document->job().commit();
    m_document->job().end();
    if (!outcome.problem.isEmpty()) {
        Q_EMIT m_document->refused(outcome.problem);
        Q_EMIT exportFailed(path);
    } else if (!outcome.verdict.isEmpty())
        Q_EMIT exported(path, outcome.verdict);
    else
        Q_EMIT m_document->noticed(tr("%1 was not written.").arg(QFileInfo(path).fileName()));
}

void ModelSaver::exportBrush()
{
    BackgroundJob& job = m_document->job();
    if (job.isBusy())
        return;
    const core::JobControl control = job.beginCancellable(tr("Making a brush of %1").arg(m_document->modelInfo().name));
    m_document->queue().enqueue([this, control] {
        m_document->worker().post([this, control, name = m_document->modelInfo().name](core::Sculptor& sculptor) {
            auto work = [copy = ModelChangeJob::copyOf(sculptor.mesh()), name, control] {
                return BrushExport::run(copy, name, control);
            };
            m_document->job().run(std::move(work), [this](const ExportedBrush& brush) { finishBrush(brush); });
        });
    });
}

void ModelSaver::finishBrush(const ExportedBrush& brush)
{
    m_document->job().commit();
    m_document->job().end();
    if (!brush.problem.isEmpty())
        Q_EMIT m_document->refused(brush.problem);
    else if (!brush.path.isEmpty())
        Q_EMIT brushExported(brush.path);
}

bool ModelSaver::saveExternally(const QString& what, Save save, std::function<void(bool isSaved)> done)
{
    if (m_document->job().isBusy())
        return false;
    m_document->job().begin(what);
    m_document->queue().enqueue(
        [this, save = std::move(save), done = std::move(done)] { startExternally(save, done); });
    return true;
}

void ModelSaver::startExternally(const Save& save, const std::function<void(bool isSaved)>& done)
{
    if (!m_document->queue().hold([this, save, done] { startExternally(save, done); }))
        return;
    m_document->queue().setPause(DocumentQueue::Pause::Changing);
    const int index = m_document->history().stack().index();
    m_document->worker().post(
        [this, save, done, present = Present{nullptr, 0, m_document->metadata(), index, recordedSteps()}](
            core::Sculptor& sculptor) mutable {
            present.mesh = std::make_shared<core::TriangleMesh>(core::extractMesh(sculptor.mesh()));
            present.hash = sculptor.mesh().meshHash();
            present.metadata.frame = sculptor.mesh().frame();
            m_document->job().run(
                [save, present] { return save(present); },
                [this, done, index = present.step](bool isSaved) { finishExternally(index, isSaved, done); });
        });
}

void ModelSaver::finishExternally(int index, bool isSaved, const std::function<void(bool isSaved)>& done)
{
    m_document->job().end();
    m_document->queue().setPause(DocumentQueue::Pause::None);
    if (isSaved)
        m_document->savedState().setSaved(index);
    done(isSaved);
    m_document->worker().strokes().release();
    m_document->notifyStateChanged();
    m_document->queue().run();
}

/// Returns the steps up to the present state; nothing if one of them is unknown.
std::optional<std::vector<core::FileEntry>> ModelSaver::recordedSteps() const
{
    const DocumentHistory& history = m_document->history();
    std::vector<core::FileEntry> steps;
    for (int i = 0; i < history.stack().index(); ++i) {
        const auto& recordedStep = static_cast<const StrokeCommand*>(history.stack().command(i))->marks().recordedStep;
        if (!recordedStep)
            return std::nullopt;
        steps.push_back(*recordedStep);
    }
    return history.isWhole() ? std::optional(std::move(steps)) : std::nullopt;
}
} // namespace app
