#pragma once

#include "core/sculpt/fuse/fusion_candidates.h"
#include "core/sculpt/fuse/ring_strip.h"
#include "core/sculpt/fuse/separation.h"

namespace core
{
/// Topology fusion (paper, section 3.4): joins what is about to meet, and separates what has grown too thin. Every
/// operation is verified by itself; what is not sound is left undone. Owns scratch memory.
class TopologyFusion
{
public:
    /// Forgets what could not be joined: a new dab tries again. `mirror`: null, or on; then what follows is done to the
    /// half, together with its image, and the regions are of the half. `detailShare`: see Separation::beginDab().
    void beginDab(MirrorMap* mirror, double detailShare);

    /// Whether the whole plan brings surfaces that are near each other into contact: seldom, even where some face each
    /// other. A guess, as what is far now may come near: no reason not to verify.
    bool predictContact(const VerifiedMesh& surface, const Region& region, const EdgeBounds& bounds);

    /// Joins what the motion of the region is about to bring into contact: surfaces that meet from outside become one,
    /// a wall that is pushed through gets a hole. Returns how many joins there were.
    std::uint64_t join(VerifiedMesh& surface, Region& region, MotionLimits& limits, const FusionInput& input);

    /// Whether surfaces that join() may not join are about to meet at one of these vertices: without fusion any, with
    /// it the two sides of a wall that is not pushed, and what is masked.
    bool isContact(const VerifiedMesh& surface, const Region& region, const FusionInput& input, bool fusion,
                   const std::vector<Slot>& vertices);

    /// See Separation::separate().
    std::uint64_t separate(VerifiedMesh& surface, Region& region, const std::vector<VertexPair>& blocked,
                           const EdgeBounds& bounds)
    {
        return m_separation.separate(surface, region, blocked, bounds);
    }

private:
    std::uint64_t joinPairs(VerifiedMesh& surface, Region& region, const EdgeBounds& bounds);
    bool mayJoin(const Mesh& mesh, const FusionPair& pair) const;
    bool joinPair(VerifiedMesh& surface, Region& region, const FusionPair& pair, const EdgeBounds& bounds);
    std::optional<Surgery> joining(const VerifiedMesh& surface, const FusionPair& pair, Stepping stepping) const;
    bool isBesideTube(const Vec3& middle, double detail) const;

    FusionSurgery m_surgery;
    FusionCandidates m_candidates;
    Separation m_separation{m_surgery};
    std::vector<Vec3> m_tubes; ///< where this dab began new ones
    SlotSet m_done;            ///< vertices around what was joined in this pass
};
} // namespace core
