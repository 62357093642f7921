#pragma once

#include "core/mesh/face_octree.h"
#include "core/sculpt/verify/dirty_neighbourhood.h"
#include "core/sculpt/verify/patch_components.h"

namespace core
{
/// The method that proved a change sound. Patch: a certificate for each changed patch. Stars: for the patches without a
/// certificate, certificates of all vertex stars and exact tests of pairs of disjoint faces. Pairs: exact tests of
/// neighbouring pairs too. In all three, pairs of faces from different patches are tested exactly.
enum class VerifyTier { Patch, Stars, Pairs };

struct VerifyResult
{
    VerifyTier tier = VerifyTier::Patch;
    /// Faulty faces, in ascending order and complete: all faces of intersecting pairs, all degenerate or wrongly linked
    /// faces, and all faces of shells that face the wrong way at their nesting depth.
    std::vector<Slot> badFaces;

    bool ok() const { return badFaces.empty(); }
};

/// Checks a change exactly and locally (core/README.md, "A dab"). If the mesh was sound before the change, then it is
/// sound after it if and only if verify() finds no bad face. Owns scratch memory. Thread: not thread-safe.
class Verifier
{
public:
    /// Verifies a change. `touched`: from the mesh's journal; all changes since `octree` was last up to date.
    VerifyResult verify(const Mesh& mesh, const FaceOctree& octree, const TouchedSlots& touched);

    /// Returns the bad faces at these vertices. Preconditions: the last verify() found a fault; the mesh now has that
    /// change again, except that these vertices have moved less far. Does not look for bad faces elsewhere. Cost: the
    /// faces around these vertices, plus a box test for each face of the last verify().
    std::vector<Slot> recheck(const Mesh& mesh, std::span<const Slot> vertices);

    /// Collects the changed faces and their boxes, without verifying anything.
    void collectDirty(const Mesh& mesh, const TouchedSlots& touched) { m_neighbourhood.collectDirty(mesh, touched); }

    /// Returns the live faces that changed (relinked, or with a moved corner) in the last verify() or collectDirty().
    std::span<const Slot> dirtyFaces() const
    {
        return std::span(m_neighbourhood.faces()).first(m_neighbourhood.dirtyCount());
    }
    /// Returns the boxes of dirtyFaces(), in the same order.
    std::span<const LatticeBox> dirtyBoxes() const
    {
        return m_neighbourhood.boxes().first(m_neighbourhood.dirtyCount());
    }
    /// Returns the number of faces that the last verify() or collectDirty() examined: the changed ones and all near
    /// them.
    Slot facesVisited() const { return m_neighbourhood.size(); }

private:
    bool certifyAll(const Mesh& mesh);
    void findMislinked(const Mesh& mesh);
    void findDegenerate();
    void testPairs(const Mesh& mesh);
    bool certifyStars(const Mesh& mesh);
    bool isStarCertified(Slot v) const { return m_stars.contains(v) && m_isStarCertified[m_stars.position(v)]; }
    bool meetBadly(Slot i, Slot j) const;
    void checkNesting(const Mesh& mesh, const FaceOctree& octree);
    bool isNestedWell(const Mesh& mesh, const FaceOctree& octree, Slot component) const;
    void addBad(Slot index) { m_result.badFaces.push_back(m_neighbourhood.faces()[index]); }

    VerifyResult m_result;
    DirtyNeighbourhood m_neighbourhood;
    PatchComponents m_components;
    SparseIndex m_stars;                 ///< vertices for whose stars a certificate was tried (certifyStar())
    std::vector<char> m_isStarCertified; ///< whether the star is certified, by position in m_stars
};
} // namespace core
