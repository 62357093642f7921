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

Document::Choice Document::choiceOf(const QString& path, LongWork& work)
{
    const auto tell = [&work](const QString& next) { work.rename(next); };
    return {tr("Opening %1").arg(QFileInfo(path).fileName()),
            [path, tell](const core::JobControl& control) { return ModelLoader::load(path, tell, control); }};
}

void Document::open(const QString& path)
{
    openFrom(choiceOf(path, m_work));
}

void Document::openLosingChanges(const QString& path)
{
    Choice choice = choiceOf(path, m_work);
    choice.losesChanges = true;
    openFrom(choice);
}

void Document::openMended(const QString& path, const core::RepairOptions& options)
{
    const QString name = QFileInfo(path).fileName();
    const auto tell = [this](const QString& next) { m_work.rename(next); };
    openFrom({tr("Opening %1").arg(name), [path, options, tell](const core::JobControl& control) {
                  return ModelLoader::loadMended(path, options, tell, control);
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
              made.losesChanges});
}

/// Changes are what they are when all strokes have reported. Who let them go for a model that does not come need not be
/// asked again.
void Document::openFrom(const Choice& choice)
{
    if (m_work.isBusy() && !m_isLoading)
        Q_EMIT noticed(tr("The model that you chose opens as soon as this is done."));
    request([this, choice] {
        if (m_work.isBusy())
            openNext(choice);
        else if (choice.losesChanges || m_letGo || mayDiscard([this, choice] { openFrom(choice); }))
            load(choice.what, choice.make);
    });
}

/// The latest choice wins: what is being opened is given up for it; what is being written is written first.
void Document::openNext(Choice choice)
{
    m_next = std::move(choice);
    if (!m_isLoading)
        return;
    m_work.stop();
    Q_EMIT stoppable(true); // the choice can still be taken back
}

void Document::openWaiting()
{
    if (const auto next = std::exchange(m_next, std::nullopt))
        openFrom(*next);
}

void Document::load(const QString& what, const Make& make)
{
    m_isLoading = m_letGo = true;
    const core::JobControl control = m_work.beginStoppable(what);
    const auto finish = [this, control](const std::shared_ptr<LoadedModel>& model) {
        m_work.keep();
        if (!control.isCancelled() && model->sculptor)
            return request([this, model] { install(model); });
        if (m_shelf)
            m_shelf->discard(model->journal);
        m_isLoading = false;
        m_letGo = m_letGo && m_next;
        m_work.end();
        if (!control.isCancelled() && model->isMendable)
            Q_EMIT mendable(model->path, model->problem);
        else if (!control.isCancelled())
            Q_EMIT refused(model->problem);
        if (m_facts.faces == 0 && !m_next) // never without a model
            openSphere();
    };
    auto work = [make, control, shelf = m_shelf] {
        auto model = std::make_shared<LoadedModel>(make(control));
        if (shelf && model->sculptor && !model->recovered && !control.isCancelled())
            model->journal = shelf->begin(*model);
        return model;
    };
    m_work.run(std::move(work), finish);
}

void Document::install(std::shared_ptr<LoadedModel> model)
{
    m_isInstalling = true;
    m_history.clear();
    m_stack.clear();
    m_lastReport.reset();
    m_isHistoryWhole = true;
    m_changedBeyondHistory = model->isUnsaved || !model->mended.isEmpty();
    m_mark = model->mark;
    m_facts.name = model->name;
    m_facts.path = model->path;
    m_facts.metadata = model->metadata;
    m_clock = {};
    m_facts.unitGuess = model->unitGuess;
    m_start = std::exchange(model->start, nullptr);
    m_recovered = std::exchange(model->recovered, nullptr);
    giveWorker(std::exchange(model->sculptor, nullptr),
               m_recovered ? m_shelf->goOn(model->offer, *m_recovered) : model->journal);
    if (!model->notice.isEmpty())
        Q_EMIT noticed(model->notice);
    if (!model->mended.isEmpty())
        Q_EMIT mended(model->name, model->mended);
}

void Document::takeModel(const MeshFacts& facts)
{
    m_isInstalling = m_isLoading = m_letGo = false;
    takeFacts(facts);
    m_work.end();
    Q_EMIT opened(m_facts);
    if (const auto recovered = std::exchange(m_recovered, nullptr))
        restore(*recovered);
    tellState();
    runRequests();
}

void Document::setPalette(std::vector<core::Rgb> palette)
{
    m_facts.metadata.palette = std::move(palette);
    describeToJournal();
}

void Document::setPath(const QString& path)
{
    m_facts.path = path;
    m_facts.name = QFileInfo(path).fileName();
    describeToJournal();
    Q_EMIT factsChanged(m_facts);
}

void Document::setName(const QString& name)
{
    m_facts.name = name;
    describeToJournal();
    Q_EMIT factsChanged(m_facts);
}

void Document::loseFile()
{
    m_changedBeyondHistory = true;
    describeToJournal();
    tellState();
}

core::DocumentMetadata Document::notesNow() const
{
    core::DocumentMetadata metadata = m_facts.metadata;
    if (m_completeNotes)
        m_completeNotes(metadata);
    return metadata;
}

void Document::save(const QString& path)
{
    const int kept = ui::Settings().preferences().keepsBackups ? ui::backupCount : 0;
    saveBy(QFileInfo(path).fileName(),
           [path, kept](const core::TriangleMesh& mesh, const core::DocumentMetadata& metadata) {
               return ModelSaving::save(path, mesh, metadata, kept);
           });
}

void Document::saveNumbered(const QString& path)
{
    saveBy(m_facts.name, [path](const core::TriangleMesh& mesh, const core::DocumentMetadata& metadata) {
        return ModelSaving::saveNumbered(path, mesh, metadata);
    });
}

void Document::saveBy(const QString& name, const Write& write)
{
    if (m_work.isBusy())
        return;
    m_work.begin(tr("Saving %1").arg(name));
    request([this, write] {
        m_worker->post([this, write, metadata = notesNow(), index = m_stack.index()](core::Sculptor& sculptor) mutable {
            metadata.frame = sculptor.mesh().frame();
            auto mesh = std::make_shared<core::TriangleMesh>(core::extractMesh(sculptor.mesh()));
            auto work = [write, metadata, mesh = std::move(mesh)] { return write(*mesh, metadata); };
            m_work.run(std::move(work), [this, index](const SavedFile& saved) { finishSaving(index, saved); });
        });
    });
}

void Document::finishSaving(int index, const SavedFile& saved)
{
    m_work.end();
    if (!saved.problem.isEmpty()) {
        Q_EMIT refused(saved.problem);
        return;
    }
    takeSaved(saved.path, index);
    if (!saved.notice.isEmpty())
        Q_EMIT noticed(saved.notice);
}

void Document::exportTo(const QString& path, quint64 mostTriangles, bool slices)
{
    if (m_work.isBusy())
        return;
    const core::JobControl control = m_work.beginStoppable(tr("Exporting %1").arg(QFileInfo(path).fileName()));
    request([this, path, mostTriangles, slices, control] {
        startExport({path, mostTriangles, slices, notesNow()}, control);
    });
}

void Document::startExport(const ExportOrder& order, const core::JobControl& control)
{
    m_worker->post([this, order = order, control](core::Sculptor& sculptor) mutable {
        order.mesh = ModelTrial::copyOf(sculptor.mesh());
        order.metadata.frame = sculptor.mesh().frame();
        auto work = [this, order, control] {
            return ModelExport::run(
                order, [this](const QString& what) { m_work.rename(what); }, control);
        };
        m_work.run(std::move(work),
                   [this, path = order.path](const ExportOutcome& outcome) { finishExport(path, outcome); });
    });
}

void Document::finishExport(const QString& path, const ExportOutcome& outcome)
{
    m_work.keep();
    m_work.end();
    if (!outcome.problem.isEmpty())
        Q_EMIT refused(outcome.problem);
    else if (!outcome.verdict.isEmpty())
        Q_EMIT exported(path, outcome.verdict);
    else
        Q_EMIT noticed(tr("%1 was not written.").arg(QFileInfo(path).fileName()));
}

void Document::keepAsBrush()
{
    if (m_work.isBusy())
        return;
    const core::JobControl control = m_work.beginStoppable(tr("Making a brush of %1").arg(m_facts.name));
    request([this, control] {
        m_worker->post([this, control, name = m_facts.name](core::Sculptor& sculptor) {
            auto work = [copy = ModelTrial::copyOf(sculptor.mesh()), name, control] {
                return BrushKeeper::keep(copy, name, control);
            };
            m_work.run(std::move(work), [this](const KeptBrush& kept) { finishBrush(kept); });
        });
    });
}

void Document::finishBrush(const KeptBrush& kept)
{
    m_work.keep();
    m_work.end();
    if (!kept.problem.isEmpty())
        Q_EMIT refused(kept.problem);
    else if (!kept.path.isEmpty())
        Q_EMIT keptAsBrush(kept.path);
}

/// The file holds what the model was at that step. If others followed, it has changes that no file holds.
void Document::takeSaved(const QString& path, int index)
{
    m_facts.path = path;
    m_facts.name = QFileInfo(path).fileName();
    describeToJournal();
    setSaved(index);
    Q_EMIT saved(path);
    tellState();
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

bool Document::handOver(const QString& what, std::function<bool(const Present& present)> keep,
                        std::function<void(bool isKept)> done)
{
    if (m_work.isBusy())
        return false;
    m_work.begin(what);
    request([this, keep = std::move(keep), done = std::move(done)] { startHandingOver(keep, done); });
    return true;
}

void Document::startHandingOver(const std::function<bool(const Present& present)>& keep,
                                const std::function<void(bool isKept)>& done)
{
    if (!m_worker->hold()) // another hand was faster
        return request([this, keep, done] { startHandingOver(keep, done); });
    m_isChanging = true; // what is asked for waits
    m_worker->post([this, keep, done, present = Present{nullptr, 0, notesNow(), m_stack.index(), deedsNow()}](
                       core::Sculptor& sculptor) mutable {
        present.mesh = std::make_shared<core::TriangleMesh>(core::extractMesh(sculptor.mesh()));
        present.hash = sculptor.mesh().meshHash();
        present.metadata.frame = sculptor.mesh().frame();
        m_work.run([keep, present] { return keep(present); },
                   [this, done, index = present.step](bool isKept) { finishHandingOver(index, isKept, done); });
    });
}

void Document::finishHandingOver(int index, bool isKept, const std::function<void(bool isKept)>& done)
{
    m_work.end();
    m_isChanging = false;
    if (isKept)
        setSaved(index);
    done(isKept);
    m_worker->release();
    tellState();
    runRequests();
}
} // namespace app
