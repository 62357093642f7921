#include "document.h"

#include "model_loader.h"
#include "stroke_command.h"

#include "core/mesh_build.h"

#include <QFileInfo>

#include <algorithm>
#include <utility>

namespace app
{
namespace
{
constexpr double clayRadius = 50; ///< mm
}

Document::Document(SculptWorker* worker, QObject* parent)
    : QObject(parent), m_worker(worker), m_history([worker](auto job) { worker->post(std::move(job)); })
{
    m_aside.setMaxThreadCount(1);
    connect(worker, &SculptWorker::strokeFinished, this, &Document::takeReport);
    connect(worker, &SculptWorker::modelSet, this, &Document::takeModel);
    connect(worker, &SculptWorker::factsChanged, this, &Document::takeFacts);
    connect(&m_stack, &QUndoStack::indexChanged, this, &Document::tellState);
    connect(&m_stack, &QUndoStack::cleanChanged, this, &Document::tellState);
    connect(&m_history, &HistoryStore::expired, this, &Document::tellState);
    connect(&m_history, &HistoryStore::lost, this, &Document::loseHistory);
}

Document::~Document()
{
    m_worker->stop();
    m_aside.waitForDone();
    m_stack.disconnect(this);
}

void Document::setMayDiscard(std::function<bool()> mayDiscard)
{
    m_mayDiscard = std::move(mayDiscard);
}

bool Document::mayDiscard() const
{
    return !isModified() || !m_mayDiscard || m_mayDiscard();
}

// --- opening and exporting ---------------------------------------------------------------------------------------------

void Document::open(const QString& path)
{
    if (m_isBusy)
        Q_EMIT noticed(tr("One file at a time: %1 waits until the other is done.").arg(QFileInfo(path).fileName()));
    else // changes are what they are when all strokes have reported
        request([this, path] {
            if (!m_isBusy && mayDiscard())
                load(path);
        });
}

void Document::openSphere()
{
    if (!m_isBusy && mayDiscard())
        load({});
}

void Document::load(const QString& path)
{
    setBusy(path.isEmpty() ? tr("Preparing the clay") : tr("Opening %1").arg(QFileInfo(path).fileName()));
    m_aside.start([this, path] {
        const auto progress = [this](const QString& what) {
            QMetaObject::invokeMethod(this, [this, what] { Q_EMIT busy(what); }, Qt::QueuedConnection);
        };
        auto model = std::make_shared<LoadedModel>(path.isEmpty() ? ModelLoader::sphere(clayRadius) : ModelLoader::load(path, progress));
        const auto finish = [this, model = std::move(model)] {
            if (model->sculptor)
                return request([this, model] { install(model); });
            setIdle();
            Q_EMIT refused(model->problem);
            if (m_facts.faces == 0) // never without a model
                load({});
        };
        QMetaObject::invokeMethod(this, finish, Qt::QueuedConnection);
    });
}

void Document::install(std::shared_ptr<LoadedModel> model)
{
    m_isInstalling = true;
    m_history.clear();
    m_stack.clear();
    m_changedBeyondHistory = false;
    m_path = model->path;
    m_facts.name = model->name;
    m_worker->setModel(std::exchange(model->sculptor, nullptr));
    if (!model->notice.isEmpty())
        Q_EMIT noticed(model->notice);
}

void Document::takeModel(const MeshFacts& facts)
{
    m_isInstalling = false;
    takeFacts(facts);
    setIdle();
    Q_EMIT opened(m_facts);
    tellState();
    runRequests();
}

void Document::exportTo(const QString& path)
{
    if (m_isBusy)
        return;
    setBusy(tr("Exporting %1").arg(QFileInfo(path).fileName()));
    request([this, path] {
        m_worker->post([this, path, index = m_stack.index()](core::Sculptor& sculptor) {
            auto copy = std::make_shared<core::TriangleMesh>(core::extractMesh(sculptor.mesh()));
            QMetaObject::invokeMethod(this, [this, path, copy, index] { write(path, copy, index); }, Qt::QueuedConnection);
        });
    });
}

void Document::write(const QString& path, std::shared_ptr<core::TriangleMesh> mesh, int index)
{
    m_aside.start([this, path, mesh = std::move(mesh), index] {
        const QString problem = ModelLoader::save(path, *mesh);
        const auto finish = [this, path, index, problem] {
            setIdle();
            if (!problem.isEmpty()) {
                Q_EMIT refused(problem);
                return;
            }
            // The file holds what the model was then. If strokes followed, it has changes that no file holds.
            if (m_stack.index() == index && !hasUnreported()) {
                m_stack.setClean();
                m_changedBeyondHistory = false;
            }
            tellState();
            Q_EMIT exported(path);
        };
        QMetaObject::invokeMethod(this, finish, Qt::QueuedConnection);
    });
}

// --- strokes and history -----------------------------------------------------------------------------------------------

void Document::beginStroke(const core::StrokeSettings& settings)
{
    m_strokeOpen = true;
    m_lastTool = settings.tool;
    strokeRequest([this, settings] { m_worker->beginStroke(Source::Desktop, settings); });
    tellState();
}

void Document::addSample(const core::StrokeSample& sample)
{
    strokeRequest([this, sample] { m_worker->addSample(Source::Desktop, sample); });
}

void Document::endStroke()
{
    strokeRequest([this] { m_worker->endStroke(Source::Desktop); });
    m_strokeOpen = false;
    std::move(m_afterStroke.begin(), m_afterStroke.end(), std::back_inserter(m_requests));
    m_afterStroke.clear();
    runRequests();
}

void Document::undo()
{
    request([this] {
        if (m_history.canUndo(m_stack.index()))
            m_stack.undo();
    });
}

void Document::redo()
{
    request([this] {
        if (m_stack.canRedo() && m_history.canRedo(m_stack.index()))
            m_stack.redo();
    });
}

void Document::goTo(int index)
{
    request([this, index] { m_stack.setIndex(std::clamp(index, m_history.firstIndex(), m_history.lastIndex())); });
}

/// What must see the model as all strokes before it left it.
void Document::request(std::function<void()> run)
{
    (m_strokeOpen ? m_afterStroke : m_requests).push_back({true, std::move(run)});
    runRequests();
}

void Document::strokeRequest(std::function<void()> run)
{
    m_requests.push_back({false, std::move(run)});
    runRequests();
}

void Document::runRequests()
{
    while (!m_requests.empty() && !(m_requests.front().afterReports && (hasUnreported() || m_isInstalling))) {
        const auto run = std::move(m_requests.front().run);
        m_requests.pop_front();
        run();
    }
}

bool Document::hasUnreported() const
{
    return m_reported < m_worker->strokesBegun();
}

void Document::takeReport(const StrokeReport& report)
{
    ++m_reported;
    if (!m_isInstalling) {
        if (report.delta) {
            const int index = m_stack.index();
            m_history.add(index, report.delta);
            m_stack.push(new StrokeCommand(report.tool, &m_history, index));
        }
        if (report.endedEarly > 0 && !report.delta)
            Q_EMIT noticed(tr("Nothing happened here: the surface would have met itself, or the wall of the working volume."));
        takeFacts(report.facts);
    }
    tellState();
    runRequests();
}

void Document::takeFacts(const MeshFacts& facts)
{
    m_facts.vertices = facts.vertices;
    m_facts.faces = facts.faces;
    m_facts.box = facts.box;
    m_facts.size = facts.box.isEmpty() ? core::Vec3::Zero() : core::Vec3(facts.box.sizes());
    if (!m_isInstalling)
        Q_EMIT factsChanged(m_facts);
}

void Document::loseHistory()
{
    m_changedBeyondHistory = isModified();
    m_history.clear();
    m_stack.clear();
    tellState();
    Q_EMIT refused(tr("The earlier steps cannot be undone any more: their file on disk cannot be read. The model is in order."));
}

bool Document::isModified() const
{
    return m_changedBeyondHistory || !m_stack.isClean() || hasUnreported();
}

bool Document::isSettled() const
{
    return !m_strokeOpen && m_requests.empty() && !hasUnreported();
}

bool Document::canUndo() const
{
    return m_strokeOpen || hasUnreported() || m_history.canUndo(m_stack.index());
}

bool Document::canRedo() const
{
    return !m_strokeOpen && !hasUnreported() && m_stack.canRedo() && m_history.canRedo(m_stack.index());
}

QString Document::undoText() const
{
    if (!canUndo())
        return {};
    return m_strokeOpen || hasUnreported() ? StrokeCommand::textOf(m_lastTool) : m_stack.undoText();
}

QString Document::redoText() const
{
    return canRedo() ? m_stack.redoText() : QString();
}

void Document::tellState()
{
    Q_EMIT historyChanged();
    if (std::exchange(m_toldModified, isModified()) != isModified())
        Q_EMIT modifiedChanged(m_toldModified);
}

void Document::setBusy(const QString& what)
{
    m_isBusy = true;
    Q_EMIT busy(what);
}

void Document::setIdle()
{
    m_isBusy = false;
    Q_EMIT idle();
}
} // namespace app
