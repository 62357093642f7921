#pragma once

#include "core/sculpt/fuse/cycle_search.h"
#include "core/sculpt/fuse/fusion_candidates.h"
#include "core/sculpt/fuse/ring_strip.h"
#include "core/sculpt/fuse/separation.h"

namespace core
{
/// Topology fusion (paper, section 3.4): joins surfaces that are about to meet, and cuts necks that are too thin. Each
/// operation is verified by itself, and skipped if the result is not sound. Owns scratch memory.
class TopologyFusion
{
public:
    /// Begins a stroke: clears the joins and tunnels of the previous stroke.
    void beginStroke();
    /// Begins a dab: clears the joins and the failures of the previous dab. `mirror`: null, or on; then the regions
    /// cover only the positive side, and each operation is done on both sides. `detailShare`, `shredSize`: see
    /// Separation::beginDab().
    void beginDab(MirrorMap* mirror, double detailShare, double shredSize);

    /// Returns whether the complete plan would bring surfaces that are near each other now into contact. This is a
    /// guess, because other surfaces may come near on the way; the change must still be verified.
    bool predictContact(const VerifiedMesh& surface, const Region& region, const EdgeBounds& bounds);

    /// Joins surfaces that the motion of the region is about to bring into contact. Surfaces that meet from outside
    /// become one; a wall that is pushed through gets a hole. The mesh around a join is not quasi-uniform until it is
    /// optimised. Returns the number of joins.
    std::uint64_t join(VerifiedMesh& surface, Region& region, MotionLimits& limits, const FusionInput& input);

    /// Returns whether surfaces that join() must not join are about to meet at one of these vertices. Without fusion
    /// these are all surfaces; with fusion, masked surfaces and the two sides of a wall that is not pushed.
    bool isContact(const VerifiedMesh& surface, const Region& region, const FusionInput& input, bool fusion,
                   const std::vector<Slot>& vertices);

    /// Cuts necks and removes specks: see Separation::separate().
    std::uint64_t separate(VerifiedMesh& surface, Region& region, const std::vector<VertexPair>& blocked,
                           const EdgeBounds& bounds);

    /// Returns a measure of the time spent: see FusionCandidates::takeVisits().
    std::uint64_t takeVisits() { return m_candidates.takeVisits(); }
    /// Returns whether this stroke has joined anything.
    bool hasJoints() const { return m_joints.size() > 0; }
    /// Returns whether this dab has joined anything.
    bool hasJoined() const { return m_joined.size() > 0; }
    /// Returns whether the vertex is at a join of this dab.
    bool isJoined(Slot v) const { return m_joined.contains(v); }
    /// Adds the vertices at this dab's joins to the region, if they are not in it yet.
    void addJoined(Region& region, const Mesh& mesh, const Vec3& center) const;
    /// Merges adjacent joins into one: fills the short tunnels between joins that met from outside, and cuts the thin
    /// strands between holes pushed through a wall. Holes and handles that existed before the dab remain. Then calls
    /// Separation::cutCycles() at the stroke's joins in the region. Returns the number of changes.
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
    std::vector<Vec3> m_tunnels; ///< centres of the tunnels that this stroke has started, mm
    SlotSet m_done;              ///< vertices around the joins of the current round
    SlotSet m_joints;  ///< vertices around the joins of this stroke; slots may since have been freed or reused
    SlotSet m_joined;  ///< vertices around the joins of this dab; slots may since have been freed or reused
    SlotSet m_pierced; ///< the vertices in m_joined that are at holes pushed through a wall
};
} // namespace core
