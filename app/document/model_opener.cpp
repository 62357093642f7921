#include "app/document/model_opener.h"

#include "app/document/document.h"
#include "app/model/model_loader.h"
#include "app/recovery/recovery_store.h"
#include "app/worker/sculpt_worker.h"

#include "ui/settings/settings.h"

#include <QFileInfo>

#include <utility>

namespace app
{
namespace
{
/// Returns a choice that opens the repaired model, whose losses the user has accepted.
ModelOpener::Choice acceptedChoice(LoadedModel model)
{
    model.doubt.reset();
    ModelOpener::Choice choice{ModelOpener::tr("Opening %1").arg(model.name),
                               [model](const core::JobControl&) { return model; }};
    choice.path = model.source;
    return choice;
}
} // namespace

ModelOpener::ModelOpener(Document* document) : m_document(document)
{
    connect(&document->worker(), &SculptWorker::modelSet, this, &ModelOpener::finish);
    connect(&document->history().stack(), &QUndoStack::indexChanged, this, [this] {
        m_isDiscardAgreed = false;
        m_discardAgreedFor.clear();
    });
}

void ModelOpener::setDiscardPrompt(DiscardPrompt prompt)
{
    m_prompt = std::move(prompt);
}

bool ModelOpener::canDiscard(const std::function<void()>& proceed) const
{
    return !m_document->savedState().isModified() || !m_prompt || m_prompt(proceed);
}

ModelOpener::Choice ModelOpener::choiceOf(const QString& path) const
{
    const auto onStage = [&job = m_document->job()](const QString& next) { job.rename(next); };
    const auto objects = ui::Settings().get<ui::Preferences>().opensObjectsAsParts ? ModelLoader::Objects::AsParts
                                                                                   : ModelLoader::Objects::AsOnePart;
    Choice choice{tr("Opening %1").arg(QFileInfo(path).fileName()),
                  [path, onStage, objects](const core::JobControl& control) {
                      return ModelLoader::load(path, onStage, control, objects);
                  }};
    choice.path = path;
    return choice;
}

void ModelOpener::open(const QString& path)
{
    openMade(choiceOf(path));
}

void ModelOpener::openDiscardingChanges(const QString& path)
{
    Choice choice = choiceOf(path);
    choice.discardsChanges = true;
    openMade(choice);
}

void ModelOpener::openRepaired(const QString& path, const core::RepairOptions& options)
{
    Choice choice = choiceOf(path);
    choice.make = [path, options, &job = m_document->job()](const core::JobControl& control) {
        return ModelLoader::loadRepaired(
            path, options, [&job](const QString& next) { job.rename(next); }, control);
    };
    openMade(choice);
}

void ModelOpener::openBall()
{
    openStarter(core::Starter::Ball);
}

void ModelOpener::openStarter(core::Starter starter)
{
    openMade({tr("Preparing the clay"), [starter](const core::JobControl&) { return ModelLoader::starter(starter); }});
}

void ModelOpener::recover(quint64 offer, const QString& name)
{
    openMade({tr("Recovering %1").arg(name),
              [recoveryStore = m_document->journaling().recoveryStore(), offer](const core::JobControl& control) {
                  return recoveryStore->recover(offer, control);
              }});
}

/// Waits until all strokes are reported, then asks about unsaved changes. A user who has agreed to lose changes is not
/// asked again if that model cannot be opened.
void ModelOpener::openMade(const Choice& choice)
{
    m_document->changer().dropPreview();
    if (m_document->job().isBusy() && !m_isLoading)
        Q_EMIT m_document->noticed(tr("The model that you chose will open as soon as this is done."));
    m_document->queue().enqueue([this, choice] {
        const bool isAgreed = choice.discardsChanges || m_isDiscardAgreed ||
                              (!choice.path.isEmpty() && choice.path == m_discardAgreedFor);
        if (m_document->job().isBusy())
            chooseNext(choice);
        else if (isAgreed || canDiscard([this, choice] { openMade(choice); }))
            load(choice);
    });
}

void ModelOpener::chooseNext(const Choice& choice)
{
    m_next = choice;
    if (!m_isLoading)
        return;
    m_document->job().cancel();
    Q_EMIT m_document->job().cancellable(true); // the new choice can still be cancelled
}

void ModelOpener::openNext()
{
    if (const auto next = std::exchange(m_next, std::nullopt))
        openMade(*next);
}

void ModelOpener::load(const Choice& choice)
{
    m_isLoading = m_isDiscardAgreed = true;
    m_discardAgreedFor.clear();
    const core::JobControl control = m_document->job().beginCancellable(choice.what);
    auto work = [make = choice.make, control, recoveryStore = m_document->journaling().recoveryStore()] {
        auto model = std::make_shared<LoadedModel>(make(control));
        if (recoveryStore && model->sculptor && !model->recovered && !model->doubt && !control.isCancelled())
            model->journal = recoveryStore->begin(*model);
        return model;
    };
    m_document->job().run(std::move(work),
                          [this, control, mark = choice.mark](const std::shared_ptr<LoadedModel>& model) {
                              m_document->job().commit();
                              if (!control.isCancelled() && model->sculptor && !model->doubt)
                                  m_document->queue().enqueue([this, model, mark] { install(*model, mark); });
                              else
                                  refuse(*model, control.isCancelled());
                          });
}

void ModelOpener::refuse(const LoadedModel& model, bool isStopped)
{
    if (RecoveryStore* recoveryStore = m_document->journaling().recoveryStore())
        recoveryStore->discard(model.journal);
    m_isLoading = false;
    if (m_isDiscardAgreed && (model.doubt || model.isRepairable))
        m_discardAgreedFor = model.source;
    m_isDiscardAgreed = m_isDiscardAgreed && m_next;
    m_document->job().end();
    if (!isStopped && model.doubt)
        Q_EMIT m_document->repairDoubted(*model.doubt, [this, model] { openMade(acceptedChoice(model)); });
    else if (!isStopped && model.isRepairable)
        Q_EMIT repairable(model.path, model.problem);
    else if (!isStopped)
        Q_EMIT m_document->refused(model.problem);
    if (m_document->modelInfo().faces == 0 && !m_next) // there must always be a model
        openBall();
}

void ModelOpener::install(LoadedModel& model, const std::shared_ptr<const void>& mark)
{
    m_document->queue().setPause(DocumentQueue::Pause::Installing);
    m_document->history().clear(true);
    m_document->savedState().setModifiedBeyondHistory(model.isUnsaved || !model.repairs.isEmpty());
    m_document->setModel(model);
    m_document->changer().setStart(model.start);
    m_mark = mark;
    m_document->journaling().begin(model);
    if (!model.notice.isEmpty())
        Q_EMIT m_document->noticed(model.notice);
    if (!model.repairs.isEmpty())
        Q_EMIT repaired(model.name, model.repairs);
}

/// Called when the worker has the model.
void ModelOpener::finish(const MeshFacts& facts)
{
    m_document->queue().setPause(DocumentQueue::Pause::None);
    m_isLoading = m_isDiscardAgreed = false;
    m_document->takeFacts(facts);
    m_document->job().end();
    Q_EMIT m_document->opened(m_document->modelInfo());
    m_document->journaling().restore();
    m_document->notifyStateChanged();
    m_document->queue().run();
}
} // namespace app
