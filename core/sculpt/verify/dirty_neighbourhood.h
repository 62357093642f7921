#pragma once

#include "core/mesh/face_octree.h"
#include "core/sculpt/verify/patch_certificate.h"
#include "core/util/sparse_index.h"

namespace core
{
/// The faces that a change has touched (the dirty faces), and all other faces that these may intersect. Functions
/// identify a face by its index in faces(): relinked faces come first, then the other dirty faces, then the rest. Owns
/// scratch memory. Thread: not thread-safe.
class DirtyNeighbourhood
{
public:
    /// Collects only the dirty faces: live faces that were relinked or have a corner that moved. `touched`: from the
    /// mesh's journal.
    void collectDirty(const Mesh& mesh, const TouchedSlots& touched);
    /// Adds every other face whose box meets a box of the change. Precondition: collectDirty() was called for the same
    /// change.
    void gather(const Mesh& mesh, const FaceOctree& octree, const TouchedSlots& touched);
    /// Builds the index that indexOf() needs. Cost: O(faces).
    void buildIndex();
    /// Reads a face's points and box again after its corners have moved.
    void reread(const Mesh& mesh, Slot index) { read(mesh, std::span(&faces()[index], 1), index); }

    const std::vector<Slot>& faces() const { return m_faces.slots(); }
    bool contains(Slot f) const { return m_faces.contains(f); }
    Slot size() const { return static_cast<Slot>(m_faces.size()); }
    Slot dirtyCount() const { return m_dirtyCount; }
    Slot relinkedCount() const { return m_relinkedCount; }
    /// Returns the index of a face in faces(), or noSlot. Precondition: buildIndex().
    Slot indexOf(Slot f) const { return m_index.find(f); }

    // --- queries by index in faces() ---------------------------------------------------------------------------------
    const PatchFace& shape(Slot index) const { return m_shapes[index]; }
    std::span<const PatchFace> shapes() const { return std::span(m_shapes).first(m_faces.size()); }
    std::span<const LatticeBox> boxes() const { return std::span(m_boxes).first(m_faces.size()); }
    bool isDegenerate(Slot index) const;
    /// Returns the normal of a face, whose length is twice the face's area. Exact. Units: squared lattice units.
    Vec3 normal(Slot index) const;

private:
    std::span<const LatticeBox> dirtyBoxes() const { return std::span(m_boxes).first(m_dirtyCount); }
    std::vector<LatticeBox> boxesOfChange(const Mesh& mesh, const TouchedSlots& touched);
    void read(const Mesh& mesh, std::span<const Slot> faces, std::size_t first);

    SlotSet m_faces;
    SparseIndex m_index;
    std::vector<PatchFace> m_shapes; ///< shapes in the order of m_faces; elements beyond m_faces.size() are unused
    std::vector<LatticeBox> m_boxes; ///< boxes in the order of m_faces; elements beyond m_faces.size() are unused
    Slot m_relinkedCount = 0;
    Slot m_dirtyCount = 0;
    SparseIndex m_moved; ///< vertices of the change that existed before it
};
} // namespace core
