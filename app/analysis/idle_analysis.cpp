#include "app/analysis/idle_analysis.h"

#include "app/document/document.h"
#include "app/worker/sculpt_worker.h"

#include "core/mesh/mesh_builder.h"
#include "core/parts/part_split.h"
#include "core/sculpt/sculptor.h"

#include <algorithm>

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

ModelCopy copyOf(const core::Mesh& mesh, AnalysedParts parts, core::PartId active)
{
    ModelCopy all{core::extractMesh(mesh), liveVertices(mesh), mesh.lattice()};
    const core::PartList& list = mesh.frame().parts;
    const auto isLeftOut = [&](core::PartId id) {
        return (parts == AnalysedParts::Active && id != active) ||
               (parts == AnalysedParts::Visible && !list.isVisible(id));
    };
    if (std::ranges::none_of(list.all(), isLeftOut, &core::Part::id))
        return all;
    std::vector<core::PartPiece> pieces = core::splitByPart(all.mesh);
    std::erase_if(pieces, [&](const core::PartPiece& piece) { return isLeftOut(piece.part); });
    if (pieces.empty())
        return all;
    ModelCopy copy{core::joined(pieces), {}, all.lattice};
    for (const core::PartPiece& piece : pieces)
        std::ranges::transform(piece.points, std::back_inserter(copy.slots),
                               [&](core::Slot v) { return all.slots[v]; });
    return copy;
}
} // namespace

IdleAnalysis::IdleAnalysis(Document* document, SculptWorker* worker, AnalysedParts parts)
    : QObject(document)
    , m_document(document)
    , m_worker(worker)
    , m_parts(parts)
{
    m_idleTimer.setSingleShot(true);
    m_idleTimer.setInterval(idleMs);
    connect(&m_idleTimer, &QTimer::timeout, this, &IdleAnalysis::run);
    connect(document, &Document::historyChanged, this, [this] {
        if (!isOfPresent())
            invalidate();
    });
    connect(document, &Document::opened, this, &IdleAnalysis::invalidate);
    connect(&document->parts(), &DocumentParts::changed, this, [this] {
        if (m_parts == AnalysedParts::Active && m_document->parts().active() != m_active)
            invalidate();
    });
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
    m_active = m_document->parts().active();
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
    m_worker->post([this, active = m_document->parts().active(), stop = m_stop.get_token()](core::Sculptor& sculptor) {
        if (!stop.stop_requested())
            analyse(std::make_shared<ModelCopy>(copyOf(sculptor.mesh(), m_parts, active)), stop);
    });
}
} // namespace app
