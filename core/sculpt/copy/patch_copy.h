#pragma once

#include "core/sculpt/copy/changed_patch.h"
#include "core/sculpt/verify/verified_mesh.h"
#include "core/stroke/radial_symmetry.h"

namespace core
{
/// Copies the change that a dab made in its sector to other sectors, by quarter or half turns. Each copy replaces the
/// patch there by the turned patch from here. A quarter turn maps the lattice onto itself, so patches that were exact
/// images of each other stay so, bit for bit. Thread: not thread-safe.
class PatchCopy
{
public:
    /// Reads the change to be copied. For the parameters and costs see ChangedPatch::read().
    void learn(const VerifiedMesh& surface, const Mesh::Mark& mark, std::vector<Sphere> balls);

    /// Returns whether the change can be copied by each of these turns. Before the change, the surface must have been
    /// symmetric under the turn, colours and masks included. The turned balls must contain no other faces, and no two
    /// copies may overlap. Precondition: the octree is up to date. Cost: the patch.
    bool match(const VerifiedMesh& surface, std::span<const Turn> turns);
    /// Copies the change by the turn with this index, in one transaction; each turn only once. Returns false, with
    /// nothing changed, if the result does not verify. Precondition: match() returned true.
    bool place(VerifiedMesh& surface, std::size_t turn);

    /// Returns the image of a vertex under the turn of the last place(). Returns noSlot if the vertex is not part of
    /// the patch.
    Slot imageOf(Slot v) const;
    /// Returns the vertices of the patch, for which imageOf() is defined.
    const std::vector<Slot>& vertices() const { return m_patch.vertices().slots(); }
    bool isNothing() const { return m_patch.isNothing(); }

private:
    bool find(const VerifiedMesh& surface, const Turn& turn);
    bool matchVertex(const VerifiedMesh& surface, const Turn& turn, Slot v);
    bool matchFrom(const Mesh& mesh, const Turn& turn, std::size_t face);
    bool matchAcross(const Mesh& mesh, const Turn& turn, const Triangle& corners, std::vector<std::size_t>& front);
    bool isAllMatched(const VerifiedMesh& surface, const Turn& turn) const;
    bool claim(std::span<const Slot> vertices);
    Surgery exchange(const Mesh& mesh, const Turn& turn) const;
    void write(Mesh& mesh, const Turn& turn);
    Slot& image(Slot v) { return m_images[m_patch.vertices().position(v)]; }

    ChangedPatch m_patch;
    std::vector<Turn> m_turns;
    std::vector<std::vector<Slot>> m_places; ///< for each turn: images, by position among the patch's vertices
    std::vector<Slot> m_images;              ///< images for the turn in progress in find() or place()
    std::vector<char> m_seen;                ///< find(): whether a face of the patch has been visited
    SlotSet m_matched;                       ///< faces of the surface that are images of the patch's faces
    SlotSet m_claimed;                       ///< changed vertices of the patch and of all its images so far
};
} // namespace core
