#pragma once

#include "core/sculpt/fuse/fusion_surgery.h"
#include "core/sculpt/remesh/remesh.h"

#include <utility>

namespace core
{
/// Separates the surface where an edge that is too short can no longer be collapsed (the counterpart of the paper's
/// section 3.4): cuts a neck three edges around, removes a speck.
class Separation
{
public:
    explicit Separation(FusionSurgery& surgery) : m_surgery(surgery) {}

    /// `detailShare`: the tool's own d in terms of the brush's. A speck is small against the brush, however fine the
    /// mesh.
    /// `shredSize`: the longest side of what is removed when it comes off at a neck, in mm, a shred that a drag has
    /// drawn out too thin; 0: only specks are.
    void beginDab(double detailShare, double shredSize)
    {
        m_detailShare = detailShare;
        m_shredSize = shredSize;
    }

    /// Cuts necks that have grown as thin as a triangle, and removes specks smaller than 2 of the brush's d. `blocked`:
    /// edges shorter than d that could not be collapsed. Returns how many separations there were.
    std::uint64_t separate(VerifiedMesh& surface, Region& region, const std::vector<VertexPair>& blocked,
                           const EdgeBounds& bounds);

    /// Cuts necks at these vertices that are narrower than d: cycles of three edges, whose ends are capped. Removes
    /// specks and small voids there. `rest`: null, or of a stroke that keeps detail, where d is less. Returns how many
    /// of all these there were.
    std::uint64_t cutCycles(VerifiedMesh& surface, Region& region, const std::vector<Slot>& vertices,
                            const EdgeBounds& bounds, const RestLengths* rest);

    /// Removes the components of these vertices that are specks.
    void removeSpecks(VerifiedMesh& surface, Region& region, const std::vector<Slot>& vertices,
                      const EdgeBounds& bounds);

    /// Returns the middles of the necks that were cut since the last call, in mm.
    std::vector<Vec3> takeNecks() { return std::exchange(m_necks, {}); }

private:
    enum class Also { Nothing, Voids, Shreds };

    bool cutNeck(VerifiedMesh& surface, Region& region, const VertexPair& edge, double maxPerimeter,
                 const EdgeBounds& bounds);
    bool removeSpeck(VerifiedMesh& surface, Region& region, Slot vertex, const EdgeBounds& bounds,
                     Also also = Also::Nothing);
    void removeShred(VerifiedMesh& surface, Region& region, Slot vertex, Slot body, const EdgeBounds& bounds);
    bool isOwnImage(const Mesh& mesh, const Triangle& cycle) const;

    FusionSurgery& m_surgery;
    double m_detailShare = 1, m_shredSize = 0;
    std::vector<Vec3> m_necks; ///< see takeNecks()
};
} // namespace core
