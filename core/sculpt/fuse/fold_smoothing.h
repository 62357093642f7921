#pragma once

#include "core/sculpt/edit/mesh_editor.h"
#include "core/sculpt/select/region.h"
#include "core/sculpt/verify/verified_mesh.h"

namespace core
{
/// Smooths the surface locally where it has folded up so far that its faces meet, and keeps account of the motion of
/// the dab that this takes back. The paper (section 3.4) smooths where a join makes triangles meet. Here such a join is
/// done with the other stepping or left undone, and smoothing prepares the retry of a sub-step that did not verify
/// (DabPipeline::prepareRetry).
class FoldSmoothing
{
public:
    /// Forgets the motion that was taken back. To be called when a dab begins.
    void clear();

    /// Moves the region's vertices at and around the given ones half way to the mean of their neighbours, as a
    /// transaction of its own. `vertices`: some may be removed. `mayTakeBack`: vertices may move against their plans,
    /// else only across and along them. Returns whether anything was moved.
    bool smooth(VerifiedMesh& surface, MeshEditor edit, Region& region, std::span<const Slot> vertices,
                bool mayTakeBack);

    /// Returns the share of the longest displacement planned that is left when the share `done` of the plan has been
    /// done. Cost: O(1) if nothing was smoothed, else O(region).
    double shareLeft(const Region& region, double done) const;

private:
    SparseIndex m_vertices;          ///< smoothed in this dab
    std::vector<double> m_takenBack; ///< mm against their plan, by position in m_vertices
};
} // namespace core
