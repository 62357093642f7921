// Where the document's model comes from, and where it goes.

#include "app/document/document.h"

#include "app/model/brush_export.h"
#include "app/model/model_change_job.h"
#include "app/model/model_export.h"
#include "app/model/model_loader.h"
#include "app/model/model_saving.h"
#include "app/recovery/recovery_store.h"

#include "core/mesh/mesh_builder.h"
#include "ui/settings/settings.h"

#include <QFileInfo>

#include <utility>

namespace app
{
namespace
{
constexpr double startRadius = 50; ///< mm
} // namespace

Document::Choice Document::choiceOf(const QString& path, BackgroundJob& work)
{
    const auto onStage = [&work](const QString& next) { work.rename(next); };
    return {tr("Opening %1").arg(QFileInfo(path).fileName()),
            [path, onStage](const core::JobControl& control) { return ModelLoader::load(path, onStage, control); }};
}

void Document::open(const QString& path)
{
    openFrom(choiceOf(path, m_job));
}

void Document::openDiscardingChanges(const QString& path)
{
    Choice choice = choiceOf(path, m_job);
    choice.discardsChanges = true;
    openFrom(choice);
}

void Document::openRepaired(const QString& path, const core::RepairOptions& options)
{
    const QString name = QFileInfo(path).fileName();
    const auto onStage = [this](const QString& next) { m_job.rename(next); };
    openFrom({tr("Opening %1").arg(name), [path, options, onStage](const core::JobControl& control) {
                  return ModelLoader::loadRepaired(path, options, onStage, control);
              }});
}

void Document::openSphere()
{
    openFrom({tr("Preparing the clay"), [](const core::JobControl&) { return ModelLoader::sphere(startRadius); }});
}

void Document::openStarter(core::Starter starter)
{
    openFrom({tr("Preparing the clay"), [starter](const core::JobControl&) { return ModelLoader::starter(starter); }});
}

void Document::openMade(const Made& made)
{
    openFrom({made.what,
              [make = made.make, mark = made.mark](const core::JobControl& control) {
                  LoadedModel model = make(control);
                  model.mark = mark;
                  return model;
              },
              made.discardsChanges});
}

/// Changes are what they are when all strokes have reported. Who let them go for a model that does not come need not be
/// asked again.
void Document::openFrom(const Choice& choice)
{
    if (m_job.isBusy() && !m_isLoading)
        Q_EMIT noticed(tr("The model that you chose opens as soon as this is done."));
    request([this, choice] {
        if (m_job.isBusy())
            openNext(choice);
        else if (choice.discardsChanges || m_isDiscardAgreed || canDiscard([this, choice] { openFrom(choice); }))
            load(choice.what, choice.make);
    });
}

/// The latest choice wins: what is being opened is given up for it; what is being written is written first.
void Document::openNext(Choice choice)
{
    m_next = std::move(choice);
    if (!m_isLoading)
        return;
    m_job.cancel();
    Q_EMIT cancellable(true); // the choice can still be taken back
}

void Document::openWaiting()
{
    if (const auto next = std::exchange(m_next, std::nullopt))
        openFrom(*next);
}

void Document::load(const QString& what, const Make& make)
{
    m_isLoading = m_isDiscardAgreed = true;
    const core::JobControl control = m_job.beginCancellable(what);
    const auto finish = [this, control](const std::shared_ptr<LoadedModel>& model) {
        m_job.commit();
        if (!control.isCancelled() && model->sculptor)
            return request([this, model] { install(model); });
        if (m_recoveryStore)
            m_recoveryStore->discard(model->journal);
        m_isLoading = false;
        m_isDiscardAgreed = m_isDiscardAgreed && m_next;
        m_job.end();
        if (!control.isCancelled() && model->isRepairable)
            Q_EMIT repairable(model->path, model->problem);
        else if (!control.isCancelled())
            Q_EMIT refused(model->problem);
        if (m_modelInfo.faces == 0 && !m_next) // never without a model
            openSphere();
    };
    auto work = [make, control, recoveryStore = m_recoveryStore] {
        auto model = std::make_shared<LoadedModel>(make(control));
        if (recoveryStore && model->sculptor && !model->recovered && !control.isCancelled())
            model->journal = recoveryStore->begin(*model);
        return model;
    };
    m_job.run(std::move(work), finish);
}

void Document::install(std::shared_ptr<LoadedModel> model)
{
    m_isInstalling = true;
    m_history.clear();
    m_stack.clear();
    m_lastReport.reset();
    m_isHistoryWhole = true;
    m_changedBeyondHistory = model->isUnsaved || !model->repairs.isEmpty();
    m_mark = model->mark;
    m_modelInfo.name = model->name;
    m_modelInfo.path = model->path;
    m_modelInfo.metadata = model->metadata;
    m_workTimer = {};
    m_modelInfo.unitGuess = model->unitGuess;
    m_start = std::exchange(model->start, nullptr);
    m_recovered = std::exchange(model->recovered, nullptr);
    giveWorker(std::exchange(model->sculptor, nullptr),
               m_recovered ? m_recoveryStore->resume(model->offer, *m_recovered) : model->journal);
    if (!model->notice.isEmpty())
        Q_EMIT noticed(model->notice);
    if (!model->repairs.isEmpty())
        Q_EMIT repaired(model->name, model->repairs);
}

void Document::takeModel(const MeshFacts& facts)
{
    m_isInstalling = m_isLoading = m_isDiscardAgreed = false;
    takeFacts(facts);
    m_job.end();
    Q_EMIT opened(m_modelInfo);
    if (const auto recovered = std::exchange(m_recovered, nullptr))
        restore(*recovered);
    notifyStateChanged();
    runRequests();
}

void Document::setPalette(std::vector<core::Rgb> palette)
{
    m_modelInfo.metadata.palette = std::move(palette);
    describeToJournal();
}

void Document::setPath(const QString& path)
{
    m_modelInfo.path = path;
    m_modelInfo.name = QFileInfo(path).fileName();
    describeToJournal();
    Q_EMIT modelInfoChanged(m_modelInfo);
}

void Document::setName(const QString& name)
{
    m_modelInfo.name = name;
    describeToJournal();
    Q_EMIT modelInfoChanged(m_modelInfo);
}

void Document::onFileDeleted()
{
    m_changedBeyondHistory = true;
    describeToJournal();
    notifyStateChanged();
}

core::DocumentMetadata Document::presentMetadata() const
{
    core::DocumentMetadata metadata = m_modelInfo.metadata;
    if (m_completeMetadata)
        m_completeMetadata(metadata);
    return metadata;
}

void Document::save(const QString& path)
{
    const int backups = ui::Settings().preferences().keepsBackups ? ui::backupCount : 0;
    saveBy(QFileInfo(path).fileName(),
           [path, backups](const core::TriangleMesh& mesh, const core::DocumentMetadata& metadata) {
               return ModelSaving::save(path, mesh, metadata, backups);
           });
}

void Document::saveNumbered(const QString& path)
{
    saveBy(m_modelInfo.name, [path](const core::TriangleMesh& mesh, const core::DocumentMetadata& metadata) {
        return ModelSaving::saveNumbered(path, mesh, metadata);
    });
}

void Document::saveBy(const QString& name, const Write& write)
{
    if (m_job.isBusy())
        return;
    m_job.begin(tr("Saving %1").arg(name));
    request([this, write] {
        m_worker->post(
            [this, write, metadata = presentMetadata(), index = m_stack.index()](core::Sculptor& sculptor) mutable {
                metadata.frame = sculptor.mesh().frame();
                auto mesh = std::make_shared<core::TriangleMesh>(core::extractMesh(sculptor.mesh()));
                auto work = [write, metadata, mesh = std::move(mesh)] { return write(*mesh, metadata); };
                m_job.run(std::move(work), [this, index](const SavedFile& saved) { finishSaving(index, saved); });
            });
    });
}

void Document::finishSaving(int index, const SavedFile& saved)
{
    m_job.end();
    if (!saved.problem.isEmpty()) {
        Q_EMIT refused(saved.problem);
        return;
    }
    takeSaved(saved.path, index);
    if (!saved.notice.isEmpty())
        Q_EMIT noticed(saved.notice);
}

void Document::exportTo(const QString& path, quint64 maxTriangles, bool slices)
{
    if (m_job.isBusy())
        return;
    const core::JobControl control = m_job.beginCancellable(tr("Exporting %1").arg(QFileInfo(path).fileName()));
    request([this, path, maxTriangles, slices, control] {
        startExport({path, maxTriangles, slices, presentMetadata()}, control);
    });
}

void Document::startExport(const ExportRequest& request, const core::JobControl& control)
{
    m_worker->post([this, request = request, control](core::Sculptor& sculptor) mutable {
        request.mesh = ModelChangeJob::copyOf(sculptor.mesh());
        request.metadata.frame = sculptor.mesh().frame();
        auto work = [this, request, control] {
            return ModelExport::run(
                request, [this](const QString& what) { m_job.rename(what); }, control);
        };
        m_job.run(std::move(work),
                  [this, path = request.path](const ExportOutcome& outcome) { finishExport(path, outcome); });
    });
}

void Document::finishExport(const QString& path, const ExportOutcome& outcome)
{
    m_job.commit();
    m_job.end();
    if (!outcome.problem.isEmpty())
        Q_EMIT refused(outcome.problem);
    else if (!outcome.verdict.isEmpty())
        Q_EMIT exported(path, outcome.verdict);
    else
        Q_EMIT noticed(tr("%1 was not written.").arg(QFileInfo(path).fileName()));
}

void Document::exportBrush()
{
    if (m_job.isBusy())
        return;
    const core::JobControl control = m_job.beginCancellable(tr("Making a brush of %1").arg(m_modelInfo.name));
    request([this, control] {
        m_worker->post([this, control, name = m_modelInfo.name](core::Sculptor& sculptor) {
            auto work = [copy = ModelChangeJob::copyOf(sculptor.mesh()), name, control] {
                return BrushExport::run(copy, name, control);
            };
            m_job.run(std::move(work), [this](const ExportedBrush& brush) { finishBrush(brush); });
        });
    });
}

void Document::finishBrush(const ExportedBrush& brush)
{
    m_job.commit();
    m_job.end();
    if (!brush.problem.isEmpty())
        Q_EMIT refused(brush.problem);
    else if (!brush.path.isEmpty())
        Q_EMIT brushExported(brush.path);
}

/// The file holds what the model was at that step. If others followed, it has changes that no file holds.
void Document::takeSaved(const QString& path, int index)
{
    m_modelInfo.path = path;
    m_modelInfo.name = QFileInfo(path).fileName();
    describeToJournal();
    setSaved(index);
    Q_EMIT saved(path);
    notifyStateChanged();
}

void Document::setSaved(int index)
{
    if (m_stack.index() != index || hasUnreported())
        return;
    m_stack.setClean();
    ++m_savings;
    m_changedBeyondHistory = false;
    if (m_journal)
        m_journal->saved(static_cast<std::uint32_t>(index));
}

bool Document::saveExternally(const QString& what, std::function<bool(const Present& present)> keep,
                              std::function<void(bool isKept)> done)
{
    if (m_job.isBusy())
        return false;
    m_job.begin(what);
    request([this, keep = std::move(keep), done = std::move(done)] { startHandingOver(keep, done); });
    return true;
}

void Document::startHandingOver(const std::function<bool(const Present& present)>& keep,
                                const std::function<void(bool isKept)>& done)
{
    if (!m_worker->hold()) // another hand was faster
        return request([this, keep, done] { startHandingOver(keep, done); });
    m_isChanging = true; // what is asked for waits
    m_worker->post(
        [this, keep, done, present = Present{nullptr, 0, presentMetadata(), m_stack.index(), recordedSteps()}](
            core::Sculptor& sculptor) mutable {
            present.mesh = std::make_shared<core::TriangleMesh>(core::extractMesh(sculptor.mesh()));
            present.hash = sculptor.mesh().meshHash();
            present.metadata.frame = sculptor.mesh().frame();
            m_job.run([keep, present] { return keep(present); },
                      [this, done, index = present.step](bool isKept) { finishHandingOver(index, isKept, done); });
        });
}

void Document::finishHandingOver(int index, bool isKept, const std::function<void(bool isKept)>& done)
{
    m_job.end();
    m_isChanging = false;
    if (isKept)
        setSaved(index);
    done(isKept);
    m_worker->release();
    notifyStateChanged();
    runRequests();
}
} // namespace app
