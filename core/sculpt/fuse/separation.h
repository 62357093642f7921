#pragma once

#include "core/sculpt/fuse/fusion_surgery.h"
#include "core/sculpt/remesh/remesh.h"

#include <utility>

namespace core
{
/// Separates the surface where an edge shorter than d can no longer be collapsed (the counterpart of the paper's
/// section 3.4): cuts a neck along a cycle of three edges, or removes a speck.
class Separation
{
public:
    explicit Separation(FusionSurgery& surgery) : m_surgery(surgery) {}

    /// Begins a dab. `detailShare`: the tool's d as a share of the brush's d. Specks are measured by the brush's d,
    /// however fine the mesh is.
    /// `shredSize`: largest extent, in mm, of a part that is removed when a drag has drawn it out so thin that it comes
    /// off; 0: only specks are removed.
    void beginDab(double detailShare, double shredSize)
    {
        m_detailShare = detailShare;
        m_shredSize = shredSize;
    }

    /// Cuts necks whose cycle of three edges has become too short, and removes specks smaller than 2 d of the brush.
    /// `blocked`: edges shorter than d that could not be collapsed. Returns the number of separations.
    std::uint64_t separate(VerifiedMesh& surface, Region& region, const std::vector<VertexPair>& blocked,
                           const EdgeBounds& bounds);

    /// Cuts necks narrower than d at these vertices, along cycles of three edges, and caps their ends. Removes specks
    /// and small voids there. `rest`: null, or the rest lengths of a stroke that keeps detail; then d is smaller where
    /// the mesh was finer. Returns the number of all these changes.
    std::uint64_t cutCycles(VerifiedMesh& surface, Region& region, const std::vector<Slot>& vertices,
                            const EdgeBounds& bounds, const RestLengths* rest);

    /// Removes each component that is a speck and contains one of these vertices.
    void removeSpecks(VerifiedMesh& surface, Region& region, const std::vector<Slot>& vertices,
                      const EdgeBounds& bounds);

    /// Returns the middles, in mm, of the necks cut since the last call.
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
    std::vector<Vec3> m_necks; ///< middles of the necks that were cut, mm
};
} // namespace core
