#pragma once

#include "core/sculpt/edit/mesh_editor.h"
#include "core/sculpt/select/region.h"
#include "core/sculpt/verify/verified_mesh.h"

namespace core
{
/// Smooths the surface locally where it has folded up so far that its faces intersect, and records how much of the
/// dab's motion this undoes. In the paper (section 3.4), smoothing follows a join that makes triangles intersect. Here
/// such a join is retried with the other Stepping or skipped. Smoothing prepares the retry of a sub-step that did not
/// verify (DabPipeline::prepareRetry).
class FoldSmoothing
{
public:
    /// Clears the recorded motion. To be called when a dab begins.
    void clear();

    /// Moves the given vertices of the region and their neighbours halfway to the mean of their own neighbours, in one
    /// transaction. `vertices`: some may have been removed. `mayTakeBack`: vertices may also move against their planned
    /// direction. Returns whether anything was moved.
    bool smooth(VerifiedMesh& surface, MeshEditor edit, Region& region, std::span<const Slot> vertices,
                bool mayTakeBack);

    /// Returns the share of the longest planned displacement that remains after smoothing, if the share `done` of the
    /// plan was done. Cost: O(1) if nothing was smoothed, else O(region).
    double shareLeft(const Region& region, double done) const;

private:
    SparseIndex m_vertices;          ///< vertices smoothed in this dab
    std::vector<double> m_takenBack; ///< distance moved against the plan, mm, by position in m_vertices
};
} // namespace core
