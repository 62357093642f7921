#pragma once

#include "core/geometry/lattice.h"
#include "core/geometry/triangle_mesh.h"
#include "core/mesh/mesh_delta.h"
#include "core/mesh/surgery.h"
#include "core/util/slot_map.h"

// EigenVectorT.hh needs vector_traits declared before it.
// clang-format off
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/Geometry/EigenVectorT.hh>
// clang-format on

#include <cassert>
#include <span>

namespace core
{
/// What an open journal has seen since a mark. Slots are distinct, in the order of first touch.
struct TouchedSlots
{
    struct Place
    {
        Slot vertex;
        Vec3f point;
    };
    std::vector<Slot> vertices;        ///< moved, relinked, created or removed
    std::vector<Slot> faces;           ///< relinked, created or removed; not those of which only a corner moved
    std::vector<Place> before;         ///< of the vertices that were there, each once: where they were then
    std::vector<Triangle> facesBefore; ///< of the faces that were there: their corners then
};

/// The surface: an OpenMesh kernel whose elements are recycled slots, and the one gate through which it is written. The
/// gate notes an element's before-image at its first touch; undo, rollback, verification and dirty ranges are readers
/// of that journal. Closed triangle meshes only: each half-edge has a face. Not thread-safe.
///
/// Vertices, edges, half-edges and faces are named by their slots; half-edges 2e and 2e+1 belong to edge e.
class Mesh
{
public:
    /// Builds connectivity. Precondition: `mesh` is closed, manifold and consistently oriented, each point lies on the
    /// lattice and each vertex has a face; slots are the indices.
    Mesh(const TriangleMesh& mesh, Lattice lattice);

    const MeshFrame& frame() const { return m_frame; }
    const Lattice& lattice() const { return m_frame.lattice; }
    /// d_detail of the uniform topology: at first 4/3 of the mean edge (Botsch and Kobbelt 2004).
    double uniformDetail() const { return m_frame.uniformDetail; }

    // --- queries
    SlotCounts slots() const { return {m_vertexSlots.size(), m_edgeSlots.size(), m_faceSlots.size()}; }
    SlotCounts live() const { return {m_vertexSlots.live(), m_edgeSlots.live(), m_faceSlots.live()}; }
    bool isVertex(Slot v) const { return !m_vertexSlots.isFree(v); }
    bool isEdge(Slot e) const { return !m_edgeSlots.isFree(e); }
    bool isFace(Slot f) const { return !m_faceSlots.isFree(f); }
    /// The live vertices, edges and faces, ascending.
    LiveSlots vertices() const { return LiveSlots(m_vertexSlots); }
    LiveSlots edges() const { return LiveSlots(m_edgeSlots); }
    LiveSlots faces() const { return LiveSlots(m_faceSlots); }

    const Vec3f& point(Slot v) const { return m_kernel.points()[v]; }
    LatticePoint latticePoint(Slot v) const { return m_frame.lattice.toLattice(point(v)); }
    Rgb color(Slot v) const;
    /// How far the vertex is kept from whatever a brush does: 0 not at all, 255 wholly.
    std::uint8_t mask(Slot v) const { return m_kernel.vertex_colors()[v][3]; }
    /// Of a displacement, the part that the mask leaves: 0 to 1.
    double freedom(Slot v) const { return (255 - mask(v)) / 255.0; }
    /// By half or more: then it is not remeshed away and does not fuse (the same bound as in Blender's dynamic
    /// topology).
    bool isMasked(Slot v) const { return mask(v) >= 128; }
    /// Whether the mask lets the edge go: neither of its ends is masked. A split leaves the shape: it needs just one
    /// that is not.
    bool mayGo(Slot e) const { return !isMasked(to(2 * e)) && !isMasked(to(2 * e + 1)); }
    bool mayBeSplit(Slot e) const { return !isMasked(to(2 * e)) || !isMasked(to(2 * e + 1)); }
    const Triangle& corners(Slot f) const { return m_corners[f]; }

    Slot to(Slot h) const { return slot(m_kernel.to_vertex_handle(halfedge(h))); }
    Slot from(Slot h) const { return to(h ^ 1); }
    Slot next(Slot h) const { return slot(m_kernel.next_halfedge_handle(halfedge(h))); }
    Slot prev(Slot h) const { return slot(m_kernel.prev_halfedge_handle(halfedge(h))); }
    Slot face(Slot h) const { return slot(m_kernel.face_handle(halfedge(h))); }
    /// An outgoing half-edge of a live vertex.
    Slot outgoing(Slot v) const { return slot(m_kernel.halfedge_handle(vertexHandle(v))); }
    Slot faceHalfedge(Slot f) const { return slot(m_kernel.halfedge_handle(faceHandle(f))); }
    /// The next outgoing half-edge of the same vertex, counter-clockwise.
    Slot rotate(Slot h) const { return prev(h) ^ 1; }
    /// The half-edge v0 -> v1, or noSlot. Cost: the valence of v0.
    Slot findHalfedge(Slot v0, Slot v1) const;
    unsigned valence(Slot v) const;

    template <class Visit> void forEachOutgoing(Slot v, Visit visit) const
    {
        const Slot first = outgoing(v);
        Slot h = first;
        do {
            visit(h);
            h = rotate(h);
        } while (h != first);
    }

    // --- edits, only while a stroke is open
    void setPoint(Slot v, const Vec3f& p); ///< p lies on the lattice
    void setColor(Slot v, Rgb color);
    void setMask(Slot v, std::uint8_t mask);
    /// Puts a vertex into edge e at p, with the mean colour and mask of its ends. Returns the vertex.
    Slot splitEdge(Slot e, const Vec3f& p);
    /// Exchanges faces for others. Returns the vertices that came. Precondition: isSurgeryOk(*this, surgery).
    std::vector<Slot> replaceFaces(const Surgery& surgery);
    /// Whether collapsing h leaves a closed 2-manifold: the ends have just two common neighbours, and no valence falls
    /// below 3.
    bool isCollapseOk(Slot h) const;
    /// Merges from(h) into to(h), which moves to p and gets the mean colour and mask of both, weighted by distance.
    /// Precondition: isCollapseOk(h).
    void collapse(Slot h, const Vec3f& p);
    /// Whether the opposite corners of e are not neighbours already and its ends keep valence 3.
    bool isFlipOk(Slot e) const;
    void flip(Slot e);
    /// Puts every vertex elsewhere, on another lattice perhaps: `points`, by slot, lie on it. O(mesh), as the next
    /// three.
    void relocate(const Lattice& lattice, std::span<const Vec3f> points);
    /// Every face looks to the other side. Twice is the identity.
    void reverseOrientation();
    /// Becomes the other mesh slot for slot; what is alike is not touched. No mark may be open.
    void assign(const Mesh& other);
    /// Sets what the mesh keeps as a whole. Preconditions: a stroke is open; the lattice is the mesh's own.
    void setFrame(const MeshFrame& frame);

    // --- the journal
    void beginStroke();
    bool strokeOpen() const { return m_strokeOpen; }
    /// Closes the stroke; images of elements that came and went again within it are kept, they are part of the state.
    MeshDelta endStroke();

    /// A point of the open stroke that rollback can return to. Marks nest: rolling back to one drops those after it.
    struct Mark
    {
        std::size_t vertices, edges, faces;
        SlotCounts counts;
        std::uint32_t epoch;
        MeshFrame frame = {};
        std::size_t removed = 0;
    };
    Mark mark();
    /// Restores the state of the mark bit for bit. The mark stays usable.
    void rollback(const Mark& mark);
    /// Forgets that elements were touched again since the mark (they keep their stroke image). Keeps the journal's
    /// length at the number of distinct elements the stroke touched. The mark is spent.
    void commit(const Mark& mark);

    /// A mark that outlives the commits of marks after it, so that the images since it tell of all that these changed.
    /// One at a time, until forget(), which is its commit. Between the two nothing before it is rolled back.
    Mark remember();
    void forget(const Mark& mark);

    /// The vertices that went in the open stroke, and were not brought back by a rollback, in order. A slot may have
    /// been another vertex's since.
    const std::vector<Slot>& removedVertices() const { return m_removed; }

    TouchedSlots touchedSince(const Mark& mark) const;
    /// Images since the mark: of an element touched several times since, the first is its state at the mark.
    std::span<const VertexImage> vertexImagesSince(const Mark& mark) const;
    std::span<const FaceImage> faceImagesSince(const Mark& mark) const;

    /// Exchanges the mesh's state with the delta's. Precondition: no stroke is open, and the mesh is in the state in
    /// which the delta's stroke ended (to undo) or began (to redo).
    void swap(MeshDelta& delta);

    /// Digest of the live surface, independent of slots and order (mesh_hash.h). O(1): kept up by the journal.
    std::uint64_t meshHash() const { return m_meshHash; }
    /// Digest of slots, links, free slots and frame too. O(mesh).
    std::uint64_t stateHash() const;

private:
    struct Traits : OpenMesh::DefaultTraits
    {
        using Point = Vec3f;
        using Color = OpenMesh::Vec4uc; ///< red, green, blue, mask
        VertexAttributes(OpenMesh::Attributes::Color);
        HalfedgeAttributes(OpenMesh::Attributes::PrevHalfedge);
        EdgeAttributes(OpenMesh::Attributes::None);
        FaceAttributes(OpenMesh::Attributes::None);
    };
    using Kernel = OpenMesh::TriMesh_ArrayKernelT<Traits>;

    static constexpr Triangle freeCorners = {0, 0, 0};
    static OpenMesh::VertexHandle vertexHandle(Slot v) { return OpenMesh::VertexHandle(static_cast<int>(v)); }
    static OpenMesh::HalfedgeHandle halfedge(Slot h) { return OpenMesh::HalfedgeHandle(static_cast<int>(h)); }
    static OpenMesh::EdgeHandle edgeHandle(Slot e) { return OpenMesh::EdgeHandle(static_cast<int>(e)); }
    static OpenMesh::FaceHandle faceHandle(Slot f) { return OpenMesh::FaceHandle(static_cast<int>(f)); }
    static Slot slot(OpenMesh::BaseHandle handle) { return static_cast<Slot>(handle.idx()); }

    double meanEdge() const;
    void touchVertex(Slot v);
    void touchEdge(Slot e);
    void touchFace(Slot f);
    void setOutgoing(Slot v, Slot h);
    void setTo(Slot h, Slot v);
    void setFace(Slot h, Slot f);
    void link(Slot f, Slot h0, Slot h1, Slot h2); ///< makes the three half-edges the face's boundary
    void relabelCorner(Slot f, Slot from, Slot to);
    Slot newVertex(Slot hint, const Vec3f& p, const OpenMesh::Vec4uc& colorAndMask);
    Slot newEdge(Slot hint);
    Slot newFace(Slot hint);
    void freeVertex(Slot v);
    void freeEdge(Slot e);
    void freeFace(Slot f);

    void resize(const SlotCounts& counts);
    void reserve(const SlotCounts& counts);
    void assignVertex(const Mesh& other, Slot v);
    void assignEdge(const Mesh& other, Slot e);
    void assignFace(const Mesh& other, Slot f);
    void swapImage(VertexImage& image);
    void swapImage(EdgeImage& image);
    void swapImage(FaceImage& image);

    MeshFrame m_frame;
    Kernel m_kernel;
    std::vector<Triangle> m_corners;
    SlotMap m_vertexSlots, m_edgeSlots, m_faceSlots;

    /// The epoch in which an element was last journalled; it is journalled again when a later mark opened a new epoch.
    std::vector<std::uint32_t> m_vertexStamp, m_edgeStamp, m_faceStamp;
    std::uint32_t m_epoch = 0;
    std::uint32_t m_strokeEpoch = 0;
    /// A commit forgets images of what was touched since: the stroke's epoch, or that of remember().
    std::uint32_t m_baseEpoch = 0;
    bool m_strokeOpen = false;
    MeshDelta m_journal;
    std::vector<Slot> m_removed; ///< see removedVertices()
    std::uint64_t m_meshHash = 0;
};
} // namespace core
