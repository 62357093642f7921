#pragma once

#include "core/sculpt/edit/mesh_editor.h"
#include "core/sculpt/select/region.h"
#include "core/sculpt/verify/verified_mesh.h"

namespace core
{
/// Local smoothing where the surface has folded up so far that its faces meet (paper, section 3.4), and what that takes
/// back of a dab's motion.
class FoldSmoothing
{
public:
    /// Forgets the motion that was taken back: a new dab begins.
    void clear();

    /// Moves the region's vertices at and around the given ones half way to the mean of their neighbours, as a
    /// transaction of its own. `vertices`: may be gone. `mayTakeBack`: else only across their plans and onwards. False
    /// if nothing was moved.
    bool smooth(VerifiedMesh& surface, MeshEditor edit, Region& region, std::span<const Slot> vertices,
                bool mayTakeBack);

    /// Returns the share of the longest displacement planned that is left when the share `done` of the plan has been
    /// done. Cost: O(1) if nothing was smoothed, else O(region).
    double shareLeft(const Region& region, double done) const;

private:
    SparseIndex m_vertices;          ///< smoothed in this dab
    std::vector<double> m_takenBack; ///< how far against their plan, by position among them
};
} // namespace core
