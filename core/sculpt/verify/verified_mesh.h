#pragma once

#include "core/mesh/dirty_slots.h"
#include "core/sculpt/verify/verifier.h"

#include <functional>

namespace core
{
/// A mesh together with data that follows its changes: the octree and the ranges to be redrawn. The verifier checks
/// each change before these are updated, except the changes of commitUnverified() and follow().
class VerifiedMesh
{
public:
    explicit VerifiedMesh(Mesh& mesh) : m_mesh(mesh), m_octree(mesh) {}

    Mesh& mesh() { return m_mesh; }
    const Mesh& mesh() const { return m_mesh; }
    const FaceOctree& octree() const { return m_octree; }
    DirtySlots& dirtySlots() { return m_dirtySlots; }
    /// Restricts all queries, and so all later changes, to the faces of this part.
    void activate(PartId part) { m_octree.activate(part); }

    /// Switches verification on or off; see Sculptor::setVerification().
    void setVerification(bool on) { m_verification = on; }

    /// Verifies the changes since the mark and commits them if they are sound. Otherwise returns false and leaves the
    /// rollback to the caller; badFaces() contains the faulty faces.
    bool verify(const Mesh::Mark& mark);
    /// Rechecks a change in which verify() found a fault, after these vertices have moved less far (see
    /// Verifier::recheck()). Returns false if a fault remains, which is then in badFaces(). If true, the change must
    /// still be verified.
    bool recheck(std::span<const Slot> vertices);
    /// Verifies the changes since the mark without any effect. Allocates memory, so that later verifications are fast.
    void warmUp(const Mesh::Mark& mark) { m_verifier.verify(m_mesh, m_octree, m_mesh.touchedSince(mark)); }
    /// Runs the operation and verifies the result. If it is not sound, rolls it back and returns false.
    bool tryOperation(const std::function<void()>& operation);
    /// Returns the number of faces that the last verify() examined. They cost a few microseconds each where the surface
    /// is crumpled.
    Slot facesVisited() const { return m_verifier.facesVisited(); }
    /// Returns the faces in which the last verify() or recheck() found a fault.
    const std::vector<Slot>& badFaces() const { return m_badFaces; }

    /// Commits a change that moved no vertex, such as painting, without verifying it.
    void commitUnverified(const Mesh::Mark& mark);
    /// Updates the octree and the ranges to be redrawn after Mesh::swap().
    void follow(const MeshDelta& swapped);

    const std::array<std::uint64_t, 3>& tiers() const { return m_tiers; }
    const double& verifyMs() const { return m_verifyMs; } ///< total time spent in verify() and recheck(), milliseconds
    /// largest number of changed faces in one verify() since forgetDirtyFaces()
    Slot maxDirtyFaces() const { return m_maxDirtyFaces; }
    void forgetDirtyFaces() { m_maxDirtyFaces = 0; }

private:
    bool isSound(const TouchedSlots& touched);
    void addShownOrHidden(const PartList& before, std::vector<Slot>& faces) const;

    Mesh& m_mesh;
    FaceOctree m_octree;
    Verifier m_verifier;
    DirtySlots m_dirtySlots;
    SlotSet m_swappedFaces;
    std::vector<Slot> m_badFaces;
    std::array<std::uint64_t, 3> m_tiers{};
    double m_verifyMs = 0;
    Slot m_maxDirtyFaces = 0;
    bool m_verification = true;
};
} // namespace core
