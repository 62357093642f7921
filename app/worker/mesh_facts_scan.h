#pragma once

#include "app/worker/stroke_report.h"

#include "core/mesh/mesh_patch.h"

namespace core
{
class Mesh;
}

namespace app
{
class JobQueue;

/// Keeps the facts of the mesh up to date. Patches only enlarge the bounding box; after a stroke, a scan computes the
/// exact box and area. The scan runs as short jobs at the end of the queue, and the next stroke cancels it. Thread:
/// mesh.
class MeshFactsScan
{
public:
    /// `done` is called at the end of each scan.
    MeshFactsScan(JobQueue* queue, std::function<void()> done);

    /// Sets another mesh and its whole patch. `mesh` must stay valid until the next call. Cost: linear in the mesh.
    void reset(const core::Mesh* mesh, const core::MeshPatch& whole);
    void extend(const core::MeshPatch& patch);
    /// Begins a scan, and cancels the one in progress.
    void start();
    void cancel() { ++m_generation; }

    MeshFacts facts() const;

private:
    void scan(core::Slot first, std::uint64_t generation);

    JobQueue* m_queue;
    std::function<void()> m_done;
    const core::Mesh* m_mesh = nullptr;
    core::Box m_box, m_scannedBox;
    double m_area = 0, m_scannedArea = 0;
    std::uint64_t m_generation = 0; ///< number of the latest scan; a job of an earlier scan does nothing
};
} // namespace app
