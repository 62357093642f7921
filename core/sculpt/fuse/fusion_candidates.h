#pragma once

#include "core/sculpt/deform/motion_limits.h"
#include "core/sculpt/edit/mirror_map.h"
#include "core/sculpt/remesh/rest_lengths.h"
#include "core/sculpt/verify/verified_mesh.h"

#include <utility>

namespace core
{
/// The coming motion, as far as fusion needs to know it.
struct FusionInput
{
    bool pushes = false; ///< the tool pushes: a wall whose two sides meet gets a hole
    EdgeBounds bounds;
    double part = 1;             ///< share of the plan that the next transaction does, 0 to 1
    RestLengths* rest = nullptr; ///< null, or the rest lengths of a stroke that keeps detail
    double maxVisits = 0;        ///< joining ends after this number of pairs of near vertices has been examined
    /// Returns d_detail at a vertex, in mm: smaller than the brush's where the surface was finer before the stroke.
    double detail(Slot v) const;
};

/// Two vertices that are about to come into contact.
struct FusionPair
{
    /// the 1-rings of p and q share no vertex: joining them makes a new tunnel; otherwise it widens one
    bool startsTunnel;
    double distance2; ///< squared distance between p and q, mm2
    Slot p, q;        ///< slots of the two vertices, p < q
    bool inside;      ///< p and q are on the two sides of a wall
};

/// Finds the vertices that a motion is about to bring into contact (paper, section 3.4). Owns scratch memory.
class FusionCandidates
{
public:
    /// Returns whether any two of the faces may face each other. If not, there is nothing to join. False is certain;
    /// true is a guess. `faces`: all faces around the region. Cost: O(faces).
    static bool mayFace(const Mesh& mesh, const Region& region, std::span<const Slot> faces);

    /// Sets the mirror: null, or on; then the region covers only the positive side.
    void setMirror(MirrorMap* mirror) { m_mirror = mirror; }
    /// Finds the pairs that the motion of the region, within its limits, brings into contact.
    void find(const VerifiedMesh& surface, const Region& region, const MotionLimits& limits, const FusionInput& input);
    /// Drops pairs that would start another tunnel between a patch and its mirror image where a join has already
    /// connected the two. Does nothing without a mirror.
    void dropTunnelsBesideJoins(const Mesh& mesh);
    /// Sorts the pairs: pairs that widen a tunnel first, then by distance.
    void sort();

    const std::vector<FusionPair>& pairs() const { return m_pairs; }

    /// Returns the number of pairs of near vertices examined since takeVisits(): a measure of the time spent.
    std::uint64_t visits() const { return m_visits; }
    std::uint64_t takeVisits() { return std::exchange(m_visits, 0); }

private:
    void gather(const VerifiedMesh& surface, const Region& region, double thickness);
    void findTurned(const Mesh& mesh, const Region& region);
    void findPairs(const Mesh& mesh, const Region& region, const MotionLimits& limits, const FusionInput& input);
    void addPair(const Mesh& mesh, const Region& region, const MotionLimits& limits, const FusionInput& input,
                 Slot turned, Slot candidate);
    Box partnersBox(Slot i, double maxMotion, const FusionInput& input) const;
    bool mayPair(Slot v, Slot other) const;
    bool areFacing(const Mesh& mesh, Slot i, Slot j) const;
    bool willMeet(Slot i, Slot j, const Region& region, const MotionLimits& limits, const FusionInput& input) const;

    MirrorMap* m_mirror = nullptr;
    SlotSet m_vertices;          ///< vertices of the region and near it
    std::vector<Vec3> m_points;  ///< their points, mm, by position in m_vertices
    std::vector<Vec3> m_normals; ///< their normals, by position in m_vertices; of unit length, or zero
    /// positions in m_vertices of vertices whose normals are outside the cone of findTurned()
    std::vector<Slot> m_turned;
    std::vector<char> m_isTurned; ///< whether a vertex is in m_turned, by position in m_vertices
    std::vector<FusionPair> m_pairs;
    std::uint64_t m_visits = 0;
};
} // namespace core
