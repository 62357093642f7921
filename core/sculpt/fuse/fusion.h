#pragma once

#include "core/sculpt/deform/motion_limits.h"
#include "core/sculpt/edit/mirror_map.h"
#include "core/sculpt/fuse/ring_strip.h"
#include "core/sculpt/remesh/remesh.h"
#include "core/sculpt/verify/verified_mesh.h"

namespace core
{
struct FusionCounts
{
    std::uint64_t fusions = 0, separations = 0;

    FusionCounts& operator+=(const FusionCounts& more)
    {
        fusions += more.fusions;
        separations += more.separations;
        return *this;
    }
};

/// What a sub-step tells fusion about the motion that is to come.
struct FusionInput
{
    bool pushes = false; ///< a wall whose two sides meet gets a hole
    EdgeBounds bounds;
    double part = 1;      ///< of the plan, that one sub-step does
    double reach() const; ///< surfaces farther apart do not join: d_thickness
};

/// Topology fusion (paper, section 3.4). Every operation is verified by itself; what is not sound is left undone. Owns
/// scratch memory.
class TopologyFusion
{
public:
    /// Forgets what could not be joined: a new dab tries again. With a mirror (or none: null) all that follows is done
    /// to the half, together with its image; the regions are of the half. `detailShare`: of the brush's own d, that
    /// which the tool asks for. A speck is small against the brush, however fine the mesh.
    void beginDab(MirrorMap* mirror, double detailShare)
    {
        m_mirror = mirror;
        m_detailShare = detailShare;
        m_failed.clear();
        m_failures.clear();
        m_tubes.clear();
    }

    /// Whether two of the faces may face each other: else there is nothing to join. Cheap, and never wrong when it says
    /// no. `faces`: all around the region.
    static bool mayFuse(const Mesh& mesh, const Region& region, std::span<const Slot> faces);

    /// Whether the whole plan brings surfaces that are near each other into contact: seldom, even where some face each
    /// other. A guess, as what is far now may come near: no reason not to verify.
    bool predictContact(const VerifiedMesh& surface, const Region& region, const EdgeBounds& bounds);

    /// Joins what the motion of the region is about to bring into contact: surfaces that meet from outside become one,
    /// a wall that is pushed through gets a hole.
    FusionCounts join(VerifiedMesh& surface, Region& region, MotionLimits& limits, const FusionInput& input);

    /// Whether surfaces that join() may not join are about to meet at one of these vertices: without fusion any, with
    /// it the two sides of a wall that is not pushed, and what is masked.
    bool isContact(const VerifiedMesh& surface, const Region& region, const FusionInput& input, bool fusion,
                   const std::vector<Slot>& vertices);

    /// Cuts necks that have grown as thin as a triangle, and removes specks smaller than 2 of the brush's d. `blocked`:
    /// edges shorter than d that could not be collapsed.
    FusionCounts separate(VerifiedMesh& surface, Region& region, const std::vector<VertexPair>& blocked,
                          const EdgeBounds& bounds);

private:
    /// Joins and cuts at one vertex that may turn out unsound in a dab before it is left alone.
    static constexpr int maxFailures = 2;

    struct Near
    {
        bool isolated; ///< no vertex lies in both 1-rings: the join is a new tube, not the next stitch of a seam
        double distance2;
        Slot p, q;   ///< p < q
        bool inside; ///< the two sides of a wall
    };

    void gather(const VerifiedMesh& surface, const Region& region, double reach);
    void findNear(const Mesh& mesh, const Region& region, const MotionLimits& limits, const FusionInput& input);
    bool mayTry(Slot v) const { return !m_failed.contains(v) || m_failures[m_failed.position(v)] < maxFailures; }
    void countFailure(Slot v);
    void findTurned(const Mesh& mesh, const Region& region);
    bool willJoin(Slot i, Slot j, const Mesh& mesh, const Region& region, const MotionLimits& limits,
                  const FusionInput& input);
    bool isNamed(Slot v, Slot other);
    void keepToSeams(const Mesh& mesh);
    bool joinPair(VerifiedMesh& surface, Region& region, const Near& near, const EdgeBounds& bounds);
    std::optional<Surgery> joining(const VerifiedMesh& surface, const Near& near, Stepping stepping);
    std::optional<Surgery> completed(const VerifiedMesh& surface, const std::optional<Surgery>& half);
    std::uint64_t joinNear(VerifiedMesh& surface, Region& region, const EdgeBounds& bounds);
    bool isBesideTube(const Vec3& middle, double detail) const;
    std::optional<std::vector<Slot>> operate(VerifiedMesh& surface, Region& region, const Surgery& surgery);
    void pairUp(const Mesh& mesh, const std::vector<Slot>& created);
    bool isOnPlane(const Mesh& mesh, const Triangle& cycle) const;
    bool cut(VerifiedMesh& surface, Region& region, const VertexPair& edge, const EdgeBounds& bounds);
    void removeSpecks(VerifiedMesh& surface, Region& region, const std::vector<Slot>& vertices,
                      const EdgeBounds& bounds);
    bool removeSpeck(VerifiedMesh& surface, Region& region, Slot vertex, const EdgeBounds& bounds);

    MirrorMap* m_mirror = nullptr;
    double m_detailShare = 1;
    SlotSet m_vertices;           ///< near the region
    std::vector<Vec3> m_points;   ///< by position among them
    std::vector<Vec3> m_normals;  ///< unit length, or zero
    std::vector<Slot> m_turned;   ///< positions of those that may face another
    std::vector<char> m_isTurned; ///< by position
    std::vector<Near> m_near;
    std::vector<Vec3> m_tubes;   ///< where this dab began new ones
    SparseIndex m_failed;        ///< vertices of joins and cuts that were not sound, in this dab
    std::vector<int> m_failures; ///< how many, by position among them
    SlotSet m_done;              ///< vertices around what was joined in this pass
};
} // namespace core
