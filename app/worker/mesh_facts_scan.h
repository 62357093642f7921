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

/// The facts of the mesh. Patches only enlarge the box; the exact box and the area are found by a scan in short jobs at
/// the end of the queue, which a stroke cancels. Thread: mesh.
class MeshFactsScan
{
public:
    /// `done` is called at the end of each scan.
    MeshFactsScan(JobQueue* queue, std::function<void()> done);

    /// Another mesh, with its whole patch. Must outlive the next call. Cost: O(mesh).
    void reset(const core::Mesh* mesh, const core::MeshPatch& whole);
    void extend(const core::MeshPatch& patch);
    /// Begins a scan in place of the one that is under way.
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
    std::uint64_t m_generation = 0; ///< a scan of an older one stops
};
} // namespace app
