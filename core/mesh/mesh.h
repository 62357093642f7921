#pragma once

#include "core/geometry/lattice.h"
#include "core/geometry/triangle_mesh.h"
#include "core/mesh/mesh_delta.h"
#include "core/mesh/surgery.h"
#include "core/util/slot_map.h"

// EigenVectorT.hh needs a declaration of vector_traits before it.
// clang-format off
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/Geometry/EigenVectorT.hh>
// clang-format on

#include <algorithm>
#include <cassert>
#include <span>

namespace core
{
/// Elements journalled since a mark of the open journal. Slots are distinct, in the order of first touch.
struct TouchedSlots
{
    struct Place
    {
        Slot vertex;
        Vec3f point;
    };
    std::vector<Slot> vertices; ///< vertices moved, relinked, created or removed
    /// Faces relinked, created or removed; a face of which only a corner moved is not included.
    std::vector<Slot> faces;
    std::vector<Place> before;         ///< positions at the mark of the touched vertices that existed then, each once
    std::vector<Triangle> facesBefore; ///< corners at the mark of the touched faces that existed then
};

/// The surface: an OpenMesh kernel whose elements are recycled slots, and the only interface that writes to it. The
/// journal keeps the before-image of each element at its first touch. Undo, rollback, verification and dirty ranges
/// read this journal. Only closed triangle meshes: each half-edge has a face. Thread: one at a time.
///
/// Vertices, edges, half-edges and faces are identified by their slots; half-edges 2e and 2e+1 belong to edge e.
class Mesh
{
public:
    /// Builds the connectivity. Precondition: `mesh` is closed, manifold and consistently oriented; each point is on
    /// the lattice; each vertex has a face. Slots equal the indices in `mesh`.
    Mesh(const TriangleMesh& mesh, Lattice lattice);

    const MeshFrame& frame() const { return m_frame; }
    const Lattice& lattice() const { return m_frame.lattice; }
    /// Returns d_detail of Topology::Uniform, the length above which it splits edges, mm. Initially 4/3 of the mean
    /// edge length (Botsch and Kobbelt 2004).
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
    /// Returns how far the vertex is protected from brushes: 0 not at all, 255 completely.
    std::uint8_t mask(Slot v) const { return m_kernel.vertex_colors()[v][3]; }
    /// Returns the share of a displacement that the mask lets through, 0 to 1.
    double freedom(Slot v) const { return isHidden(v) ? 0 : (255 - mask(v)) / 255.0; }
    /// Returns whether the mask is at least one half, or the vertex is hidden. Such a vertex is neither removed by
    /// remeshing nor fused (the same threshold as in Blender's dynamic topology).
    bool isMasked(Slot v) const { return mask(v) >= 128 || isHidden(v); }
    /// Returns whether the vertex is hidden: strokes and commands leave it as it is.
    bool isHidden(Slot v) const { return (m_parts[v] & hiddenBit) != 0; }
    /// Returns whether all corners of the face are hidden. Such a face is neither drawn nor met by rays.
    bool isFaceHidden(Slot f) const
    {
        return std::ranges::all_of(m_corners[f], [&](Slot v) { return isHidden(v); });
    }
    /// Returns whether the mask allows removing the edge: both of its ends are unmasked.
    bool mayGo(Slot e) const { return !isMasked(to(2 * e)) && !isMasked(to(2 * e + 1)); }
    /// Returns whether the edge may be split: no end is hidden, and one end is unmasked. One is enough, because a split
    /// keeps the shape. At a hidden edge that is too long, splitting would not end: a vertex that is joined to both of
    /// its ends is joined to one of them by an edge too long.
    bool mayBeSplit(Slot e) const
    {
        const Slot a = to(2 * e), b = to(2 * e + 1);
        return !isHidden(a) && !isHidden(b) && !(isMasked(a) && isMasked(b));
    }
    const Triangle& corners(Slot f) const { return m_corners[f]; }
    /// Returns the part of a live vertex, or of a live face, whose corners all belong to one part.
    PartId part(Slot v) const { return m_parts[v] & maxPartId; }
    PartId partOfFace(Slot f) const { return part(m_corners[f][0]); }

    Slot to(Slot h) const { return slot(m_kernel.to_vertex_handle(halfedge(h))); }
    Slot from(Slot h) const { return to(h ^ 1); }
    Slot next(Slot h) const { return slot(m_kernel.next_halfedge_handle(halfedge(h))); }
    Slot prev(Slot h) const { return slot(m_kernel.prev_halfedge_handle(halfedge(h))); }
    Slot face(Slot h) const { return slot(m_kernel.face_handle(halfedge(h))); }
    /// Returns an outgoing half-edge of a live vertex.
    Slot outgoing(Slot v) const { return slot(m_kernel.halfedge_handle(vertexHandle(v))); }
    Slot faceHalfedge(Slot f) const { return slot(m_kernel.halfedge_handle(faceHandle(f))); }
    /// Returns the next outgoing half-edge of the same vertex, counter-clockwise.
    Slot rotate(Slot h) const { return prev(h) ^ 1; }
    /// Returns the half-edge v0 -> v1, or noSlot. Cost: O(valence of v0).
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
    void setPoint(Slot v, const Vec3f& p); ///< p must be on the lattice
    void setColor(Slot v, Rgb color);
    void setMask(Slot v, std::uint8_t mask);
    /// Moves the vertex to another part. The caller moves all vertices that are connected to it.
    void setPart(Slot v, PartId part);
    void setHidden(Slot v, bool isHidden);
    /// Inserts a vertex into edge e at p, with the mean colour and mask of the edge's ends. Returns the vertex.
    Slot splitEdge(Slot e, const Vec3f& p);
    /// Replaces faces by others. Precondition: isSurgeryOk(*this, surgery). Returns the new vertices, which belong to
    /// the part of the vertex `near`.
    std::vector<Slot> replaceFaces(const Surgery& surgery);
    /// Returns whether collapsing h leaves a closed 2-manifold: the ends of h have exactly two common neighbours, and
    /// no valence falls below 3.
    bool isCollapseOk(Slot h) const;
    /// Merges from(h) into to(h), which moves to p. Colour and mask are the mean of both ends, weighted by distance
    /// from p. Precondition: isCollapseOk(h).
    void collapse(Slot h, const Vec3f& p);
    /// Returns whether the corners opposite e are distinct and not adjacent, and the ends of e keep a valence of at
    /// least 3.
    bool isFlipOk(Slot e) const;
    void flip(Slot e);
    /// Moves every vertex to points[slot], perhaps on another lattice. Precondition: the points are on `lattice`. Cost:
    /// O(mesh).
    void relocate(const Lattice& lattice, std::span<const Vec3f> points);
    /// Reverses the orientation of every face, or of the faces of one part. A second call restores the mesh. Cost:
    /// O(mesh).
    void reverseOrientation(std::optional<PartId> part = {});
    /// Becomes a copy of `other`, slot for slot; equal elements are not touched. Precondition: no mark is open. Cost:
    /// O(mesh).
    void assign(const Mesh& other);
    /// Sets the frame. Precondition: a stroke is open, and the frame's lattice is that of the mesh.
    void setFrame(const MeshFrame& frame);

    // --- the journal
    void beginStroke();
    bool strokeOpen() const { return m_strokeOpen; }
    /// Closes the stroke. The delta keeps images of elements that were created and removed within it: they are part of
    /// the state.
    MeshDelta endStroke();

    /// A state of the open stroke that rollback() can restore. Marks nest: a rollback to a mark drops all later marks.
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
    /// Drops images of elements that were touched again since the mark, but keeps their first image of the stroke. The
    /// journal's length then is the number of distinct elements that the stroke touched. The mark becomes invalid.
    void commit(const Mark& mark);

    /// Makes a mark that survives commits of later marks, so that the images since it show the whole change.
    /// Precondition: only one exists at a time, until forget(). Marks before it must not be rolled back until then.
    Mark remember();
    void forget(const Mark& mark);

    /// Returns the vertices removed in the open stroke and not restored by a rollback, in order. A slot may have been
    /// reused since.
    const std::vector<Slot>& removedVertices() const { return m_removed; }

    TouchedSlots touchedSince(const Mark& mark) const;
    /// Returns the images since the mark. If an element has several, the first one is its state at the mark.
    std::span<const VertexImage> vertexImagesSince(const Mark& mark) const;
    std::span<const FaceImage> faceImagesSince(const Mark& mark) const;

    /// Exchanges the state of the mesh with that of the delta. Precondition: no stroke is open, and the mesh is in the
    /// state at the end of the delta's stroke (to undo) or at its beginning (to redo).
    void swap(MeshDelta& delta);

    /// Returns a digest of the live surface, independent of slots and order (mesh_hash.h). Cost: O(1), endStroke()
    /// updates it.
    std::uint64_t meshHash() const { return m_meshHash; }
    /// Returns a digest that also covers slots, links, free slots and the frame. Cost: O(mesh).
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
    void link(Slot f, Slot h0, Slot h1, Slot h2); ///< makes the three half-edges the boundary of face f
    void relabelCorner(Slot f, Slot from, Slot to);
    /// The new vertex belongs to the part of vertex `hint`.
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
    /// By vertex slot: the part, and hiddenBit if the vertex is hidden.
    std::vector<PartId> m_parts;
    SlotMap m_vertexSlots, m_edgeSlots, m_faceSlots;

    /// Epoch in which each element was last journalled. Every mark begins a new epoch, in which an element is
    /// journalled again at its next touch.
    std::vector<std::uint32_t> m_vertexStamp, m_edgeStamp, m_faceStamp;
    std::uint32_t m_epoch = 0;
    std::uint32_t m_strokeEpoch = 0;
    /// Start of the epochs whose repeated images a commit drops: the epoch of the stroke, or of remember().
    std::uint32_t m_baseEpoch = 0;
    bool m_strokeOpen = false;
    MeshDelta m_journal;
    std::vector<Slot> m_removed; ///< see removedVertices()
    std::uint64_t m_meshHash = 0;
};
} // namespace core
