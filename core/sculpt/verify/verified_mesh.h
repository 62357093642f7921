#pragma once

#include "core/mesh/dirty_slots.h"
#include "core/sculpt/verify/verifier.h"

#include <functional>

namespace core
{
/// A mesh with all that is kept in step with it: the octree, the ranges to draw anew, and the verifier, which judges each
/// change before the others learn of it.
class JudgedMesh
{
public:
    explicit JudgedMesh(Mesh& mesh) : m_mesh(mesh), m_octree(mesh) {}

    Mesh& mesh() { return m_mesh; }
    const Mesh& mesh() const { return m_mesh; }
    const FaceOctree& octree() const { return m_octree; }
    DirtySlots& dirtySlots() { return m_dirtySlots; }

    /// See Sculptor::setVerification.
    void setVerification(bool on) { m_verification = on; }

    /// Judges what changed since the mark: true commits it, false leaves it to be rolled back, and badFaces() tells why.
    bool judge(const Mesh::Mark& mark);
    /// After a change that judge() found fault with: whether it may be sound now that these vertices go less far (Verifier::recheck). It is
    /// still to be judged. If not, badFaces() tells why.
    bool mayBeSound(std::span<const Slot> vertices);
    /// Judges for nothing, to be ready for the first time that counts.
    void rehearse(const Mesh::Mark& mark) { m_verifier.verify(m_mesh, m_octree, m_mesh.touchedSince(mark)); }
    /// Runs the operation, and takes it back unless it is sound.
    bool attempt(const std::function<void()>& operation);
    /// By the last judge(), which costs some microsecond for each where the surface is crumpled.
    Slot facesLookedAt() const { return m_verifier.facesLookedAt(); }
    /// Of the last judge() or mayBeSound() that found fault.
    const std::vector<Slot>& badFaces() const { return m_badFaces; }

    /// Commits what moved nothing, as painting does.
    void commitUnjudged(const Mesh::Mark& mark);
    /// Follows Mesh::swap.
    void follow(const MeshDelta& swapped);

    const std::array<std::uint64_t, 3>& tiers() const { return m_tiers; }
    const double& verifyMs() const { return m_verifyMs; } ///< spent in judge() so far
    Slot mostDirtyFaces() const { return m_mostDirtyFaces; } ///< of one judge() since forgetDirtyFaces()
    void forgetDirtyFaces() { m_mostDirtyFaces = 0; }

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
    Slot m_mostDirtyFaces = 0;
    bool m_verification = true;
};
} // namespace core
