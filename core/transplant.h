#pragma once

#include "judged_mesh.h"
#include "sectors.h"
#include "sparse_index.h"

namespace core
{
/// The vertex that stands there, on a lattice point, or noSlot. Precondition: the octree is up to date.
Slot vertexAt(const JudgedMesh& surface, const Vec3f& p);

/// What a dab did in its sector, to be done in another by quarter or half turns: not by working there, but by exchanging the patch that was
/// there for the turned copy of what came here. A quarter turn takes the lattice to itself; so the two stay each other's image, bit for bit,
/// if they were. Not thread-safe: remembers a dab.
class Transplant
{
public:
    /// What changed since the mark of Mesh::remember(). Cost: that.
    void learn(const Mesh& mesh, const Mesh::Mark& mark);

    /// Does the same where the turn leads, in one transaction. Where the surface was not its own image under the turn, colours included, for a
    /// ring of faces around what changed, or what is to change there has changed already, or the result does not verify, it changes nothing
    /// and returns false. Precondition: the octree is up to date. Cost: what changed.
    bool place(JudgedMesh& surface, const Turn& turn);

    /// Of a vertex that was there before, or of one that has come, after place(); noSlot of one that is neither part of what changed nor beside
    /// it.
    Slot imageOf(Slot v) const;
    /// Of the vertices that have images.
    const std::vector<Slot>& vertices() const { return m_vertices.slots(); }

    /// Nothing has changed but colours.
    bool isPaint() const { return m_gone.empty() && m_come.empty() && m_moved.empty(); }
    bool isNothing() const { return isPaint() && m_coloured.empty(); }

private:
    struct State
    {
        Vec3f point;
        Rgb color;
        bool isLive;
    };
    struct Side
    {
        Slot from, to;
        std::size_t face;

        friend auto operator<=>(const Side&, const Side&) = default;
    };
    void readVertices(const Mesh& mesh, const Mesh::Mark& mark);
    void readFaces(const Mesh& mesh, const Mesh::Mark& mark);
    void collectPatch(const Mesh& mesh);
    void addUnlinked(const Mesh& mesh, Slot v);
    void addPatchFace(const Triangle& corners);
    void sortSides();
    State before(const Mesh& mesh, Slot v) const;
    bool match(const JudgedMesh& surface, const Turn& turn);
    bool matchFrom(const Mesh& mesh, const Turn& turn, std::size_t face);
    bool matchAcross(const Mesh& mesh, const Turn& turn, const Triangle& corners, std::vector<std::size_t>& front);
    bool isImage(const Mesh& mesh, const Turn& turn, Slot image, Slot v) const;
    bool claim();
    Surgery exchange(const Mesh& mesh, const Turn& turn) const;
    void write(Mesh& mesh, const Turn& turn);
    Slot& image(Slot v) { return m_images[m_vertices.position(v)]; }

    SparseIndex m_touched;
    std::vector<State> m_states; ///< before, by position among the touched
    SlotSet m_relinked;          ///< faces with other corners than before, or none
    SlotSet m_unlinked;          ///< faces of the patch that have kept theirs
    std::vector<Triangle> m_gone, m_come; ///< the relinked ones before and now
    std::vector<Slot> m_moved, m_coloured; ///< vertices that were there before
    std::vector<Triangle> m_patch; ///< as it was before: all that went or moved, and the ring around it
    std::vector<Side> m_sides;     ///< of the patch
    SparseIndex m_vertices;        ///< of the patch; first those of what went or moved, then the ring's; after place() also those that came
    Slot m_ownCount = 0;           ///< so many are the former
    std::vector<Slot> m_images;    ///< by position among m_vertices
    std::vector<char> m_seen;      ///< by face of the patch
    SlotSet m_claimed;             ///< vertices in what changed, here and at each image so far
};
} // namespace core
