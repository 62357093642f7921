#pragma once

#include "core/sculpt/verify/verified_mesh.h"
#include "core/stroke/radial_symmetry.h"
#include "core/util/sparse_index.h"

namespace core
{
/// The vertex that stands there, on a lattice point, or noSlot. Precondition: the octree is up to date.
Slot vertexAt(const VerifiedMesh& surface, const Vec3f& p);

/// What a dab did in its sector, to be done in another by quarter or half turns: not by working there, but by
/// exchanging the patch that was there for the turned copy of what came here. A quarter turn takes the lattice to
/// itself; so the two stay each other's image, bit for bit, if they were. Not thread-safe: remembers a dab.
class PatchCopy
{
public:
    /// What changed since the mark of Mesh::remember(). Precondition: the octree is up to date. Cost: that, and what
    /// lies in the balls. `balls`: in which the dab chose what to change.
    void learn(const VerifiedMesh& surface, const Mesh::Mark& mark, std::vector<Sphere> balls);

    /// Whether the same can be done where these turns lead: the surface was its own image under each, colours and masks
    /// included, for a ring of faces around what changed and in the balls, and nothing changes in two of the places.
    /// Precondition and cost: as before.
    bool match(const VerifiedMesh& surface, std::span<const Turn> turns);
    /// Does it where that one of them leads, in one transaction; false if the result does not verify: then nothing has
    /// changed. Each once.
    bool place(VerifiedMesh& surface, std::size_t turn);

    /// Of a vertex that was there before, or of one that has come, after place(); noSlot of one that is neither part of
    /// what changed nor beside it.
    Slot imageOf(Slot v) const;
    /// Of the vertices that have images.
    const std::vector<Slot>& vertices() const { return m_vertices.slots(); }

    /// Nothing has changed but colours and masks.
    bool isMarking() const { return m_gone.empty() && m_come.empty() && m_moved.empty(); }
    bool isNothing() const { return isMarking() && m_marked.empty(); }

private:
    struct State
    {
        Vec3f point;
        Rgb color;
        std::uint8_t mask;
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
    void addUnlinkedFace(const Mesh& mesh, Slot f);
    bool isAllMatched(const VerifiedMesh& surface, const Turn& turn) const;
    void addPatchFace(const Triangle& corners);
    void sortSides();
    State before(const Mesh& mesh, Slot v) const;
    bool matchAt(const VerifiedMesh& surface, const Turn& turn);
    bool matchFrom(const Mesh& mesh, const Turn& turn, std::size_t face);
    bool matchAcross(const Mesh& mesh, const Turn& turn, const Triangle& corners, std::vector<std::size_t>& front);
    bool isImage(const Mesh& mesh, const Turn& turn, Slot image, Slot v) const;
    bool claim();
    Surgery exchange(const Mesh& mesh, const Turn& turn) const;
    void write(Mesh& mesh, const Turn& turn);
    Slot& image(Slot v) { return m_images[m_vertices.position(v)]; }

    SparseIndex m_touched;
    std::vector<State> m_states;          ///< before, by position among the touched
    SlotSet m_relinked;                   ///< faces with other corners than before, or none
    SlotSet m_unlinked;                   ///< faces of the patch that have kept theirs
    std::vector<Triangle> m_gone, m_come; ///< the relinked ones before and now
    std::vector<Slot> m_moved, m_marked;  ///< vertices that were there before
    /// As it was before: all that went or moved, the ring around it, and what else is in the balls.
    std::vector<Triangle> m_patch;
    std::vector<Side> m_sides; ///< of the patch
    /// Of the patch; first those of what went or moved, then the others; after place() also those that came.
    SparseIndex m_vertices;
    Slot m_ownCount = 0; ///< so many are the former
    std::vector<Turn> m_turns;
    std::vector<std::vector<Slot>> m_places; ///< for each turn, images by position among m_vertices
    std::vector<Slot> m_images;              ///< of the turn in hand
    std::vector<char> m_seen;                ///< by face of the patch
    SlotSet m_matched;                       ///< faces that are images of the patch's
    std::vector<Sphere> m_balls;
    SlotSet m_claimed; ///< vertices in what changed, here and at each image so far
};
} // namespace core
