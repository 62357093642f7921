#include "app/document/idle_analysis.h"

#include "app/document/document.h"
#include "app/worker/sculpt_worker.h"

#include "core/mesh/mesh_builder.h"

namespace app
{
namespace
{
constexpr int restMs = 700;

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

RestingModel::RestingModel(Document* document, SculptWorker* worker)
    : QObject(document)
    , m_document(document)
    , m_worker(worker)
{
    m_rest.setSingleShot(true);
    m_rest.setInterval(restMs);
    connect(&m_rest, &QTimer::timeout, this, &RestingModel::ask);
    connect(document, &Document::historyChanged, this, &RestingModel::forget);
    connect(document, &Document::opened, this, &RestingModel::forget);
}

void RestingModel::setWanted(bool wanted)
{
    m_isWanted = wanted;
    if (wanted && !m_isAnswered)
        return m_rest.start();
    m_rest.stop();
    if (!m_isAnswered)
        m_stop.request_stop();
}

void RestingModel::askAgain()
{
    if (m_isWanted)
        ask();
}

void RestingModel::stop()
{
    m_rest.stop();
    m_stop.request_stop();
    Q_EMIT outdated();
}

void RestingModel::forget()
{
    m_stop.request_stop();
    m_isAnswered = false;
    Q_EMIT outdated();
    if (m_isWanted)
        m_rest.start();
}

void RestingModel::ask()
{
    if (!m_document->isSettled() || m_document->isBusy())
        return m_rest.start();
    m_stop.request_stop();
    m_stop = {};
    m_worker->post([this, stop = m_stop.get_token()](core::Sculptor& sculptor) {
        if (!stop.stop_requested())
            look(std::make_shared<ModelCopy>(core::extractMesh(sculptor.mesh()), liveVertices(sculptor.mesh())), stop);
    });
}
} // namespace app
