#pragma once

#include "core/geometry/triangle_intersection.h"
#include "core/mesh/face_octree.h"
#include "core/sculpt/verify/patch_certificate.h"
#include "core/util/sparse_index.h"

namespace core
{
/// What was needed to prove a change sound, besides tests of pairs of different patches: a certificate of each patch
/// that changed, certificates of all stars of one and tests of its disjoint pairs, or tests of neighbouring pairs too.
enum class VerifyTier { Patch, Stars, Pairs };

struct VerifyResult
{
    VerifyTier tier = VerifyTier::Patch;
    std::vector<Slot>
        badFaces; ///< ascending; complete: every face of every pair that meets, every face that is degenerate
                  ///< or wrongly linked, every face of a shell that turned over or was swallowed

    bool ok() const { return badFaces.empty(); }
};

/// The exact local check (DESIGN section 3, step 5). If the mesh was sound before the change, then it is sound after it
/// if and only if this finds no bad face. Not thread-safe: owns scratch memory.
class Verifier
{
public:
    /// `touched` comes from the mesh's journal and holds all that changed since `octree` was last up to date.
    VerifyResult verify(const Mesh& mesh, const FaceOctree& octree, const TouchedSlots& touched);

    /// For whoever looks for a change that is sound: after a verify() that found fault, the same change again, only
    /// that these vertices have gone less far. The bad faces at them; what else was bad is not looked for. Cost: what
    /// lies around these vertices.
    std::vector<Slot> recheck(const Mesh& mesh, std::span<const Slot> vertices);

    /// Only finds out which faces changed, and their boxes.
    void collectDirty(const Mesh& mesh, const TouchedSlots& touched);

    /// The faces of the last verify() or collectDirty() that changed: relinked or with a moved corner, and alive.
    std::span<const Slot> dirtyFaces() const { return std::span(m_gathered.slots()).first(m_dirtyCount); }
    /// Their boxes, in their order.
    std::span<const LatticeBox> dirtyBoxes() const { return std::span(m_boxes).first(m_dirtyCount); }
    /// By the last verify() or collectDirty(): those that changed, and all near them.
    Slot facesVisited() const { return static_cast<Slot>(m_gathered.size()); }

private:
    void gather(const Mesh& mesh, const FaceOctree& octree, const TouchedSlots& touched);
    std::vector<LatticeBox> boxesOf(const Mesh& mesh, const TouchedSlots& touched);
    void readFaces(const Mesh& mesh, std::span<const Slot> faces, std::size_t first);
    bool certifyAll(const Mesh& mesh);
    IntegerDirection directionOfChange() const;
    void collectBoundary(const Mesh& mesh);
    void findMislinked(const Mesh& mesh);
    void findDegenerate();
    bool isLinked(const Mesh& mesh, Slot local) const;
    void notePlaces();
    void findComponents(const Mesh& mesh);
    void addComponent(const Mesh& mesh, Slot seed);
    bool isCertified() const;
    void testPairs(const Mesh& mesh);
    bool areInOneCertified(Slot i, Slot j) const;
    bool meetBadly(Slot i, Slot j) const;
    bool certifyStars(const Mesh& mesh);
    void checkNesting(const Mesh& mesh, const FaceOctree& octree);
    bool isDirty(Slot f) const { return m_places.find(f) < m_dirtyCount; }

    /// Of the gathered faces, connected through edges.
    struct Component
    {
        bool isClosed = true;     ///< no half-edge leaves the gathered faces
        bool isCertified = false; ///< sound in itself; of those with dirty faces only
    };

    VerifyResult m_result;
    /// Changed faces first, of these the relinked ones first; then all that meet a box of the change.
    SlotSet m_gathered;
    SparseIndex m_places;            ///< where each stands among them; for what tier a leaves over
    std::vector<PatchFace> m_shapes; ///< of m_gathered, in its order; what stands behind these is of no use
    std::vector<LatticeBox> m_boxes; ///< likewise
    Slot m_relinkedCount = 0;
    Slot m_dirtyCount = 0;
    std::vector<Slot> m_component; ///< by gathered face
    std::vector<Component> m_components;
    Slot m_dirtyComponents = 0;           ///< the first ones, which hold dirty faces
    std::vector<PatchFace> m_patch;       ///< the component at work
    std::vector<BoundaryEdge> m_boundary; ///< of that, or of all that was gathered
    std::vector<Slot> m_front;            ///< of that, whose neighbours are to be looked at
    SparseIndex m_moved;                  ///< vertices that were there before
    SparseIndex m_stars;                  ///< vertices asked about
    std::vector<char> m_starCertified;
};
} // namespace core
