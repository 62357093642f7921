#pragma once

#include "core/sculpt/fuse/cycle_search.h"
#include "core/sculpt/fuse/fusion_candidates.h"
#include "core/sculpt/fuse/ring_strip.h"
#include "core/sculpt/fuse/separation.h"

namespace core
{
/// Topology fusion (paper, section 3.4): joins surfaces that are about to meet, and separates necks that are too thin.
/// Each operation is verified by itself; one that is not sound is left undone. Owns scratch memory.
class TopologyFusion
{
public:
    /// Begins a stroke: forgets the joins and tunnels of the one before.
    void beginStroke();
    /// Begins a dab: forgets the joins and the failures of the one before. `mirror`: null, or on; then the regions
    /// are of the half, and each operation is done to the half and its image. `detailShare`, `shredSize`: see
    /// Separation::beginDab().
    void beginDab(MirrorMap* mirror, double detailShare, double shredSize);

    /// Whether the whole plan would bring surfaces into contact that are near each other now. A guess, since surfaces
    /// that are far apart now may come near: the change has to be verified all the same.
    bool predictContact(const VerifiedMesh& surface, const Region& region, const EdgeBounds& bounds);

    /// Joins surfaces that the motion of the region is about to bring into contact: those that meet from outside become
    /// one, a wall that is pushed through gets a hole. The mesh around a join is not quasi-uniform until it is
    /// optimised again. Returns how many joins there were.
    std::uint64_t join(VerifiedMesh& surface, Region& region, MotionLimits& limits, const FusionInput& input);

    /// Whether surfaces that join() may not join are about to meet at one of these vertices: without fusion any, with
    /// it the two sides of a wall that is not pushed, and what is masked.
    bool isContact(const VerifiedMesh& surface, const Region& region, const FusionInput& input, bool fusion,
                   const std::vector<Slot>& vertices);

    /// See Separation::separate().
    std::uint64_t separate(VerifiedMesh& surface, Region& region, const std::vector<VertexPair>& blocked,
                           const EdgeBounds& bounds);

    /// See FusionCandidates::takeVisits().
    std::uint64_t takeVisits() { return m_candidates.takeVisits(); }
    /// Returns whether this stroke has joined anything.
    bool hasJoints() const { return m_joints.size() > 0; }
    /// Returns whether this dab has joined anything.
    bool hasJoined() const { return m_joined.size() > 0; }
    /// Whether the vertex lies at a join of this dab.
    bool isJoined(Slot v) const { return m_joined.contains(v); }
    /// Adds what this dab has joined to the region: what it met besides.
    void addJoined(Region& region, const Mesh& mesh, const Vec3& center) const;
    /// Makes one seam of two: fills the short tunnels between what this dab has joined from outside, and cuts the thin
    /// strands between the holes that it has pushed. Leaves the holes and handles that were there before. Then does as
    /// Separation::cutCycles() at what the stroke has joined in the region. Returns how many changes there were.
    std::uint64_t cutCycles(VerifiedMesh& surface, Region& region, const EdgeBounds& bounds, const RestLengths* rest);

private:
    std::uint64_t joinPairs(VerifiedMesh& surface, Region& region, const FusionInput& input);
    void forgetDetail(const Mesh& mesh, RestLengths& rest, double reach) const;
    bool mayJoin(const Mesh& mesh, const FusionPair& pair) const;
    bool joinPair(VerifiedMesh& surface, Region& region, const FusionPair& pair, const EdgeBounds& bounds);
    std::optional<Surgery> joining(const VerifiedMesh& surface, const FusionPair& pair, Stepping stepping) const;
    static SlotSet neighboursOf(const SlotSet& vertices, const Mesh& mesh, const Region* region);
    std::uint64_t mergeJoins(VerifiedMesh& surface, Region& region, const EdgeBounds& bounds);
    bool mergeJoinsAt(VerifiedMesh& surface, Region& region, Slot v, const SlotSet& around, const EdgeBounds& bounds);
    bool cut(VerifiedMesh& surface, Region& region, const std::vector<Slot>& cycle, const EdgeBounds& bounds);
    void forgetTunnelsAtNecks(double detail);

    FusionSurgery m_surgery;
    FusionCandidates m_candidates;
    Separation m_separation{m_surgery};
    CycleSearch m_cycleSearch;
    std::vector<Vec3> m_tunnels; ///< where this stroke started tunnels; mm
    SlotSet m_done;              ///< vertices around the joins of this round
    SlotSet m_joints;            ///< vertices around the joins of this stroke; some may be gone, or others by now
    SlotSet m_joined;            ///< vertices around the joins of this dab; some may be gone, or others by now
    SlotSet m_pierced;           ///< those of them at holes through a wall that is pushed
};
} // namespace core
