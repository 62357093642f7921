#include "app/document/document.h"

#include "app/model/model_loader.h"
#include "app/worker/sculpt_worker.h"

#include <QFileInfo>

#include <utility>

namespace app
{
Document::Document(SculptWorker* worker, QObject* parent)
    : QObject(parent)
    , m_worker(worker)
    , m_queue(worker)
    , m_history(worker, &m_queue)
    , m_savedState(this)
    , m_journaling(this)
    , m_lastStroke(this)
    , m_strokes(this)
    , m_parts(this)
    , m_changer(this)
    , m_opener(this)
    , m_saver(this)
{
    connect(&m_job, &BackgroundJob::idle, &m_opener, &ModelOpener::openNext, Qt::QueuedConnection);
    connect(worker, &SculptWorker::factsChanged, this, &Document::takeFacts);
    connect(&worker->strokes(), &StrokeGate::refused, this, [this] {
        if (m_changer.isPreviewing())
            Q_EMIT noticed(tr("Apply or cancel the preview before you sculpt on."));
        else if (m_queue.isPaused(DocumentQueue::Pause::Changing))
            Q_EMIT noticed(tr("Sculpting is paused until the model is ready."));
    });
    connect(&m_history.stack(), &QUndoStack::indexChanged, this, &Document::notifyStateChanged);
    connect(&m_history.stack(), &QUndoStack::cleanChanged, this, &Document::notifyStateChanged);
    connect(&m_history, &DocumentHistory::moved, this, &Document::notifyStateChanged);
    connect(&m_history.store(), &HistoryStore::expired, this, &Document::notifyStateChanged);
    connect(&m_history.store(), &HistoryStore::lost, this, &Document::loseHistory);
}

Document::~Document()
{
    m_job.cancel();
    m_worker->stop();
    m_history.stack().disconnect(this);
}

core::DocumentMetadata Document::metadata() const
{
    core::DocumentMetadata metadata = m_modelInfo.metadata;
    if (m_completeMetadata)
        m_completeMetadata(metadata);
    return metadata;
}

void Document::setCompleteMetadata(std::function<void(core::DocumentMetadata&)> complete)
{
    m_completeMetadata = std::move(complete);
}

void Document::setModel(const LoadedModel& model)
{
    m_modelInfo.name = model.name;
    m_modelInfo.path = model.path;
    m_modelInfo.source = model.source;
    m_modelInfo.metadata = model.metadata;
    m_modelInfo.unitGuess = model.unitGuess;
    m_modelInfo.objects = model.objects;
    m_workTimer = {};
}

void Document::takeFacts(const MeshFacts& facts)
{
    m_modelInfo.vertices = facts.vertices;
    m_modelInfo.faces = facts.faces;
    m_modelInfo.box = facts.box;
    m_modelInfo.area = facts.area;
    m_modelInfo.uniformDetail = facts.uniformDetail;
    m_modelInfo.minDetail = facts.minDetail;
    m_modelInfo.size = facts.box.isEmpty() ? core::Vec3::Zero() : core::Vec3(facts.box.sizes());
    if (!m_queue.isPaused(DocumentQueue::Pause::Installing))
        Q_EMIT modelInfoChanged(m_modelInfo);
}

void Document::setFile(const QString& path)
{
    m_modelInfo.path = path;
    m_modelInfo.name = QFileInfo(path).fileName();
    m_journaling.describe();
}

void Document::setPath(const QString& path)
{
    setFile(path);
    Q_EMIT modelInfoChanged(m_modelInfo);
}

void Document::setName(const QString& name)
{
    m_modelInfo.name = name;
    m_journaling.describe();
    Q_EMIT modelInfoChanged(m_modelInfo);
}

void Document::setPalette(std::vector<core::Rgb> palette)
{
    m_modelInfo.metadata.palette = std::move(palette);
    m_journaling.describe();
}

void Document::countStroke()
{
    core::WorkDone work = m_modelInfo.metadata.work.value_or(core::WorkDone());
    m_workTimer.count(work, steadyNs());
    m_modelInfo.metadata.work = work;
}

void Document::cancelJob()
{
    m_opener.forgetNext();
    m_job.cancel();
    m_changer.dropPreview();
}

void Document::loseHistory()
{
    m_savedState.setModifiedBeyondHistory(m_savedState.isModified());
    m_history.clear(false);
    m_journaling.forget();
    notifyStateChanged();
    Q_EMIT refused(tr(
        "The earlier steps can no longer be undone: their file on disk cannot be read. The model itself is intact."));
}

void Document::notifyStateChanged()
{
    Q_EMIT historyChanged();
    m_savedState.emitIfChanged();
}
} // namespace app
