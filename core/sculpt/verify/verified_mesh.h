#pragma once

#include "core/mesh/dirty_slots.h"
#include "core/sculpt/verify/verifier.h"

#include <functional>

namespace core
{
/// A mesh with all that is kept in step with it: the octree, the ranges to draw anew, and the verifier, which verifies
/// each change before the others learn of it.
class VerifiedMesh
{
public:
    explicit VerifiedMesh(Mesh& mesh) : m_mesh(mesh), m_octree(mesh) {}

    Mesh& mesh() { return m_mesh; }
    const Mesh& mesh() const { return m_mesh; }
    const FaceOctree& octree() const { return m_octree; }
    DirtySlots& dirtySlots() { return m_dirtySlots; }

    /// See Sculptor::setVerification.
    void setVerification(bool on) { m_verification = on; }

    /// Verifies what changed since the mark, and commits it if it is sound. Otherwise it is left to be rolled back, and
    /// badFaces() tells why.
    bool verify(const Mesh::Mark& mark);
    /// Whether a change in which verify() found a fault may be sound now that these vertices have moved less far
    /// (Verifier::recheck). It is still to be verified. If it is not, badFaces() tells why.
    bool recheck(std::span<const Slot> vertices);
    /// Verifies once without effect, so that the first verification that counts is fast.
    void warmUp(const Mesh::Mark& mark) { m_verifier.verify(m_mesh, m_octree, m_mesh.touchedSince(mark)); }
    /// Runs the operation, and rolls it back unless the result is sound.
    bool tryOperation(const std::function<void()>& operation);
    /// Returns the faces that the last verify() looked at: some microseconds each where the surface is crumpled.
    Slot facesVisited() const { return m_verifier.facesVisited(); }
    /// Returns the faces in which the last verify() or recheck() found a fault.
    const std::vector<Slot>& badFaces() const { return m_badFaces; }

    /// Commits a change that moved nothing, as painting does.
    void commitUnverified(const Mesh::Mark& mark);
    /// Follows Mesh::swap.
    void follow(const MeshDelta& swapped);

    const std::array<std::uint64_t, 3>& tiers() const { return m_tiers; }
    const double& verifyMs() const { return m_verifyMs; }  ///< spent in verify() so far
    Slot maxDirtyFaces() const { return m_maxDirtyFaces; } ///< of one verify() since forgetDirtyFaces()
    void forgetDirtyFaces() { m_maxDirtyFaces = 0; }

private:
    bool isSound(const TouchedSlots& touched);

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
