#include "app/worker/mesh_facts_scan.h"

#include "app/worker/job_queue.h"

#include "core/mesh/mesh.h"

#include <algorithm>
#include <utility>

namespace app
{
namespace
{
/// Vertex slots scanned by one job, with twice as many face slots. A job takes well below 1 ms.
constexpr core::Slot slotsPerJob = 1 << 16;

/// Returns the area of a face, mm^2; 0 for a free face, since its corners are equal.
double areaOf(const core::Mesh& mesh, core::Slot f)
{
    const core::Triangle& t = mesh.corners(f);
    const core::Vec3f &a = mesh.point(t[0]), &b = mesh.point(t[1]), &c = mesh.point(t[2]);
    return static_cast<double>((b - a).cross(c - a).norm()) / 2;
}
} // namespace

MeshFactsScan::MeshFactsScan(JobQueue* queue, std::function<void()> done) : m_queue(queue), m_done(std::move(done)) {}

void MeshFactsScan::reset(const core::Mesh* mesh, const core::MeshPatch& whole)
{
    cancel();
    m_mesh = mesh;
    m_box = {};
    m_area = 0;
    extend(whole);
    for (core::Slot f = 0; f < mesh->slots().faces; ++f)
        m_area += areaOf(*mesh, f);
}

void MeshFactsScan::extend(const core::MeshPatch& patch)
{
    for (const core::DrawVertex& vertex : patch.vertices)
        m_box.extend(vertex.position.cast<double>());
}

void MeshFactsScan::start()
{
    m_scannedBox.setEmpty();
    m_scannedArea = 0;
    m_queue->push(Task([this, generation = ++m_generation] { scan(0, generation); }));
}

void MeshFactsScan::scan(core::Slot first, std::uint64_t generation)
{
    if (generation != m_generation)
        return;
    const core::Slot end = std::min(m_mesh->slots().vertices, first + slotsPerJob);
    for (core::Slot v = first; v < end; ++v)
        if (m_mesh->isVertex(v))
            m_scannedBox.extend(m_mesh->point(v).cast<double>());
    for (core::Slot f = 2 * first; f < std::min(m_mesh->slots().faces, 2 * (first + slotsPerJob)); ++f)
        m_scannedArea += areaOf(*m_mesh, f);
    if (first + slotsPerJob < std::max(m_mesh->slots().vertices, m_mesh->slots().faces / 2 + 1)) {
        m_queue->push(Task([this, first, generation] { scan(first + slotsPerJob, generation); }));
        return;
    }
    m_box = m_scannedBox;
    m_area = m_scannedArea;
    m_done();
}

MeshFacts MeshFactsScan::facts() const
{
    return {m_mesh->live().vertices, m_mesh->live().faces,         m_box, m_area,
            m_mesh->uniformDetail(), m_mesh->lattice().minDetail()};
}
} // namespace app
