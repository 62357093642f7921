#pragma once

#include "core/mesh/face_octree.h"
#include "core/mesh/mesh.h"
#include "core/util/sparse_index.h"

namespace core
{
/// The change that a dab has made, and the surface around it as it was before: read from the mesh's journal. Not
/// thread-safe: remembers a dab.
class ChangedPatch
{
public:
    struct VertexState
    {
        Vec3f point;
        Rgb color;
        std::uint8_t mask;
        bool isLive;
    };

    /// Reads what has changed since the mark of Mesh::remember(). `balls`: where the dab selected.
    /// Precondition: the octree is up to date. Cost: what changed, and what lies in the balls.
    void read(const Mesh& mesh, const FaceOctree& octree, const Mesh::Mark& mark, std::vector<Sphere> balls);

    // --- what has changed --------------------------------------------------------------------------------------------
    const std::vector<Triangle>& gone() const { return m_gone; } ///< faces that went or were relinked, as they were
    const std::vector<Triangle>& come() const { return m_come; } ///< faces that came or were relinked, as they are
    const std::vector<Slot>& moved() const { return m_moved; }   ///< vertices that were there before
    const std::vector<Slot>& marked() const { return m_marked; } ///< likewise, with another colour or mask
    /// Whether nothing has changed except colours and masks.
    bool isMarking() const { return m_gone.empty() && m_come.empty() && m_moved.empty(); }
    bool isNothing() const { return isMarking() && m_marked.empty(); }

    // --- the surface as it was ---------------------------------------------------------------------------------------
    /// Returns the faces that went or moved, the ring around them, and the others in the balls.
    const std::vector<Triangle>& faces() const { return m_faces; }
    /// Returns the position of the face that has the half-edge; faces().size() if none has.
    std::size_t faceAt(Slot from, Slot to) const;
    /// Returns their vertices: first the changedCount() that went or moved. After add() also vertices that came.
    const SparseIndex& vertices() const { return m_vertices; }
    Slot changedCount() const { return m_changedCount; }
    VertexState before(const Mesh& mesh, Slot v) const;
    const std::vector<Sphere>& balls() const { return m_balls; }

    void add(Slot v) { m_vertices.add(v); }

private:
    struct Side
    {
        Slot from, to;
        std::size_t face;

        friend auto operator<=>(const Side&, const Side&) = default;
    };
    void readVertices(const Mesh& mesh, const Mesh::Mark& mark);
    void readFaces(const Mesh& mesh, const Mesh::Mark& mark);
    void collectFaces(const Mesh& mesh);
    void addUnlinkedAround(const Mesh& mesh, Slot v);
    void addUnlinked(const Mesh& mesh, Slot f);
    void addFace(const Triangle& corners);
    void sortSides();

    SparseIndex m_touched;
    std::vector<VertexState> m_states; ///< before, by position among the touched
    SlotSet m_relinked;                ///< faces with other corners than before, or none
    SlotSet m_unlinked;                ///< faces of the patch that have kept theirs
    std::vector<Triangle> m_gone, m_come;
    std::vector<Slot> m_moved, m_marked;
    std::vector<Triangle> m_faces;
    std::vector<Side> m_sides; ///< of m_faces, sorted
    SparseIndex m_vertices;
    Slot m_changedCount = 0;
    std::vector<Sphere> m_balls;
};
} // namespace core
