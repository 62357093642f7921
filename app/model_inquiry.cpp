#include "model_inquiry.h"

#include "document.h"
#include "sculpt_worker.h"

#include "core/mesh_build.h"

namespace app
{
namespace
{
constexpr int restMs = 700;
} // namespace

ModelInquiry::ModelInquiry(Document* document, SculptWorker* worker) : QObject(document), m_document(document), m_worker(worker)
{
    m_rest.setSingleShot(true);
    m_rest.setInterval(restMs);
    connect(&m_rest, &QTimer::timeout, this, &ModelInquiry::ask);
    connect(document, &Document::historyChanged, this, &ModelInquiry::forget);
    connect(document, &Document::opened, this, &ModelInquiry::forget);
}

ModelInquiry::~ModelInquiry()
{
    m_stop.request_stop();
}

void ModelInquiry::setWanted(bool wanted)
{
    m_isWanted = wanted;
    if (wanted && !m_isAnswered)
        m_rest.start();
    else if (!wanted)
        m_rest.stop();
}

void ModelInquiry::forget()
{
    m_stop.request_stop();
    m_isAnswered = false;
    Q_EMIT outdated();
    if (m_isWanted)
        m_rest.start();
}

void ModelInquiry::ask()
{
    if (!m_document->isSettled() || m_document->isBusy())
        return m_rest.start();
    m_stop.request_stop();
    m_stop = {};
    m_worker->post([this, stop = m_stop.get_token()](core::Sculptor& sculptor) {
        if (stop.stop_requested())
            return;
        auto copy = std::make_shared<core::TriangleMesh>(core::extractMesh(sculptor.mesh()));
        m_aside.run([copy = std::move(copy), stop] { return core::checkMesh(*copy, {stop, {}}); },
                    [this, stop](const core::MeshReport& report) { take(report, stop); });
    });
}

void ModelInquiry::take(const core::MeshReport& report, const std::stop_token& stop)
{
    if (stop.stop_requested())
        return;
    m_isAnswered = true;
    Q_EMIT answered(report);
}
} // namespace app
