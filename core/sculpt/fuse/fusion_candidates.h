#pragma once

#include "core/sculpt/deform/motion_limits.h"
#include "core/sculpt/edit/mirror_map.h"
#include "core/sculpt/remesh/rest_lengths.h"
#include "core/sculpt/verify/verified_mesh.h"

#include <utility>

namespace core
{
/// The motion that is to come, as fusion needs to know it.
struct FusionInput
{
    bool pushes = false; ///< a wall whose two sides meet gets a hole
    EdgeBounds bounds;
    double part = 1;             ///< share of the plan that one sub-step does
    RestLengths* rest = nullptr; ///< of a stroke that keeps detail
    double maxVisits = 0;        ///< no more is joined once so many pairs of near vertices were looked at
    /// Returns d_detail at a vertex, in mm: less than the brush's where the surface was finer before the stroke.
    double detail(Slot v) const;
};

/// Two vertices that are about to meet.
struct FusionPair
{
    bool startsTunnel; ///< no vertex lies in both 1-rings: their join makes a new tunnel; otherwise it widens one
    double distance2;  ///< mm2
    Slot p, q;         ///< p < q
    bool inside;       ///< the two sides of a wall
};

/// Finds the vertices that a motion is about to bring into contact (paper, section 3.4). Owns scratch memory.
class FusionCandidates
{
public:
    /// Whether two of the faces may face each other. Otherwise there is nothing to find. False is certain, true is a
    /// guess. `faces`: all around the region. Cost: O(faces).
    static bool mayFace(const Mesh& mesh, const Region& region, std::span<const Slot> faces);

    /// `mirror`: null, or on; then the region is of the half.
    void setMirror(MirrorMap* mirror) { m_mirror = mirror; }
    /// Finds the pairs that the motion of the region within its limits brings together.
    void find(const VerifiedMesh& surface, const Region& region, const MotionLimits& limits, const FusionInput& input);
    /// With a mirror: drops pairs that would start a tunnel between a patch and its image, where a join has connected
    /// the two already.
    void dropTunnelsBesideJoins(const Mesh& mesh);
    /// Sorts the pairs: those that widen a tunnel first, then by distance.
    void sort();

    const std::vector<FusionPair>& pairs() const { return m_pairs; }

    /// Returns the pairs of near vertices that were looked at since takeVisits(): a measure of the time spent.
    std::uint64_t visits() const { return m_visits; }
    std::uint64_t takeVisits() { return std::exchange(m_visits, 0); }

private:
    void gather(const VerifiedMesh& surface, const Region& region, double thickness);
    void findTurned(const Mesh& mesh, const Region& region);
    void findPairs(const Mesh& mesh, const Region& region, const MotionLimits& limits, const FusionInput& input);
    void addPair(const Mesh& mesh, const Region& region, const MotionLimits& limits, const FusionInput& input,
                 Slot turned, Slot near);
    Box partnersBox(Slot i, double maxMotion, const FusionInput& input) const;
    bool mayPair(Slot v, Slot other) const;
    bool areFacing(const Mesh& mesh, Slot i, Slot j) const;
    bool willMeet(Slot i, Slot j, const Region& region, const MotionLimits& limits, const FusionInput& input) const;

    MirrorMap* m_mirror = nullptr;
    SlotSet m_vertices;           ///< near the region
    std::vector<Vec3> m_points;   ///< by position in m_vertices
    std::vector<Vec3> m_normals;  ///< by position; unit length, or zero
    std::vector<Slot> m_turned;   ///< positions of vertices whose normals lie outside the cone of findTurned()
    std::vector<char> m_isTurned; ///< by position
    std::vector<FusionPair> m_pairs;
    std::uint64_t m_visits = 0;
};
} // namespace core
