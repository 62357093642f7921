#include "app/analysis/idle_analysis.h"

#include "app/document/document.h"
#include "app/worker/sculpt_worker.h"

#include "core/mesh/mesh_builder.h"
#include "core/sculpt/sculptor.h"

namespace app
{
namespace
{
constexpr int idleMs = 700;

std::vector<core::Slot> liveVertices(const core::Mesh& mesh)
{
    std::vector<core::Slot> slots;
    slots.reserve(mesh.live().vertices);
    for (core::Slot v = 0; v < mesh.slots().vertices; ++v)
        if (mesh.isVertex(v))
            slots.push_back(v);
    return slots;
}
} // namespace

IdleAnalysis::IdleAnalysis(Document* document, SculptWorker* worker)
    : QObject(document)
    , m_document(document)
    , m_worker(worker)
{
    m_idleTimer.setSingleShot(true);
    m_idleTimer.setInterval(idleMs);
    connect(&m_idleTimer, &QTimer::timeout, this, &IdleAnalysis::run);
    connect(document, &Document::historyChanged, this, [this] {
        if (!isOfPresent())
            invalidate();
    });
    connect(document, &Document::opened, this, &IdleAnalysis::invalidate);
}

void IdleAnalysis::setActive(bool active)
{
    m_isActive = active;
    if (active && !m_isFinished)
        return m_idleTimer.start();
    m_idleTimer.stop();
    if (!m_isFinished)
        m_stop.request_stop();
}

void IdleAnalysis::runNow()
{
    if (m_isActive)
        run();
}

void IdleAnalysis::stop()
{
    m_idleTimer.stop();
    m_stop.request_stop();
    Q_EMIT outdated();
}

void IdleAnalysis::setFinished()
{
    m_isFinished = true;
    m_step = m_document->history().stack().index();
}

/// Returns whether the last result describes the present model. Saving leaves it valid.
bool IdleAnalysis::isOfPresent() const
{
    return m_isFinished && m_document->queue().isSettled() && m_document->history().stack().index() == m_step;
}

void IdleAnalysis::invalidate()
{
    m_stop.request_stop();
    m_isFinished = false;
    Q_EMIT outdated();
    if (m_isActive)
        m_idleTimer.start();
}

void IdleAnalysis::run()
{
    if (!m_document->queue().isSettled() || m_document->job().isBusy())
        return m_idleTimer.start();
    m_stop.request_stop();
    m_stop = {};
    m_worker->post([this, stop = m_stop.get_token()](core::Sculptor& sculptor) {
        if (!stop.stop_requested())
            analyse(std::make_shared<ModelCopy>(core::extractMesh(sculptor.mesh()), liveVertices(sculptor.mesh())),
                    stop);
    });
}
} // namespace app
