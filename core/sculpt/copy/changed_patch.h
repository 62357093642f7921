#pragma once

#include "core/mesh/face_octree.h"
#include "core/mesh/mesh.h"
#include "core/util/sparse_index.h"

namespace core
{
/// The change that a dab has made, and the surface around the change as it was before, read from the mesh's journal.
/// Thread: not thread-safe.
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

    /// Reads the changes since a mark of Mesh::remember(). `balls`: the balls in which the dab selected vertices.
    /// Precondition: the octree is up to date. Cost: the changes, plus the faces in the balls.
    void read(const Mesh& mesh, const FaceOctree& octree, const Mesh::Mark& mark, std::vector<Sphere> balls);

    // --- the change --------------------------------------------------------------------------------------------------
    const std::vector<Triangle>& gone() const { return m_gone; } ///< faces removed or relinked, with their old corners
    const std::vector<Triangle>& come() const { return m_come; } ///< faces added or relinked, with their new corners
    const std::vector<Slot>& moved() const { return m_moved; }   ///< vertices that have moved and existed before
    /// vertices whose colour or mask has changed and that existed before
    const std::vector<Slot>& marked() const { return m_marked; }
    /// Returns whether nothing has changed except colours and masks.
    bool isMarking() const { return m_gone.empty() && m_come.empty() && m_moved.empty(); }
    bool isNothing() const { return isMarking() && m_marked.empty(); }

    // --- the surface before the change -------------------------------------------------------------------------------
    /// Returns the faces that were removed, relinked or have a changed vertex, the ring of faces around these, and all
    /// other faces in the balls; with their old corners.
    const std::vector<Triangle>& faces() const { return m_faces; }
    /// Returns the index in faces() of the face with this half-edge; faces().size() if there is none.
    std::size_t faceAt(Slot from, Slot to) const;
    /// Returns the vertices of faces(). The first changedCount() belong to removed or changed faces. add() appends
    /// vertices that are new.
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
    std::vector<VertexState> m_states; ///< states before the change, by position in m_touched
    SlotSet m_relinked;                ///< faces whose corners have changed, and faces added or removed
    SlotSet m_unlinked;                ///< faces of the patch that have kept their corners
    std::vector<Triangle> m_gone, m_come;
    std::vector<Slot> m_moved, m_marked;
    std::vector<Triangle> m_faces;
    std::vector<Side> m_sides; ///< half-edges of m_faces, sorted
    SparseIndex m_vertices;
    Slot m_changedCount = 0;
    std::vector<Sphere> m_balls;
};
} // namespace core
