#pragma once

#include "core/mesh/face_octree.h"
#include "core/sculpt/verify/dirty_neighbourhood.h"
#include "core/sculpt/verify/patch_components.h"

namespace core
{
/// The means that proved a change sound, besides tests of pairs of different patches: a certificate of each patch
/// that changed, certificates of all stars of one and tests of its disjoint pairs, or tests of neighbouring pairs too.
enum class VerifyTier { Patch, Stars, Pairs };

struct VerifyResult
{
    VerifyTier tier = VerifyTier::Patch;
    /// Ascending. Complete: every face of every pair that meets, every face that is degenerate or wrongly linked, every
    /// face of a shell that turned over or was swallowed.
    std::vector<Slot> badFaces;

    bool ok() const { return badFaces.empty(); }
};

/// The exact local check of a change (core/README.md, "A dab"). If the mesh was sound before the change, then it is
/// sound after it if and only if this finds no bad face. Not thread-safe: owns scratch memory.
class Verifier
{
public:
    /// `touched` comes from the mesh's journal and holds all that changed since `octree` was last up to date.
    VerifyResult verify(const Mesh& mesh, const FaceOctree& octree, const TouchedSlots& touched);

    /// Returns bad faces at these vertices, after a verify() that found fault and the same change again, only that they
    /// have moved less far. Does not look for other faces that were bad. Cost: the faces around these vertices.
    std::vector<Slot> recheck(const Mesh& mesh, std::span<const Slot> vertices);

    /// Only finds out which faces changed, and their boxes.
    void collectDirty(const Mesh& mesh, const TouchedSlots& touched) { m_neighbourhood.collectDirty(mesh, touched); }

    /// Returns the faces of the last verify() or collectDirty() that changed: relinked or with a moved corner, and
    /// alive.
    std::span<const Slot> dirtyFaces() const
    {
        return std::span(m_neighbourhood.faces()).first(m_neighbourhood.dirtyCount());
    }
    /// Returns their boxes, in their order.
    std::span<const LatticeBox> dirtyBoxes() const
    {
        return m_neighbourhood.boxes().first(m_neighbourhood.dirtyCount());
    }
    /// Returns how many faces the last verify() or collectDirty() looked at: those that changed, and all near them.
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
    SparseIndex m_stars;                 ///< vertices of whose faces a certificate was tried (certifyStar)
    std::vector<char> m_isStarCertified; ///< by position among them
};
} // namespace core
