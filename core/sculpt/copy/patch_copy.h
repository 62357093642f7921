#pragma once

#include "core/sculpt/copy/changed_patch.h"
#include "core/sculpt/verify/verified_mesh.h"
#include "core/stroke/radial_symmetry.h"

namespace core
{
/// Copies what a dab did in its sector to other sectors, by quarter or half turns: the patch there is exchanged for the
/// turned copy of the patch here. A quarter turn maps the lattice onto itself, so the two stay each other's image, bit
/// for bit, if they were. Not thread-safe: remembers a dab.
class PatchCopy
{
public:
    /// Learns what has changed: see ChangedPatch::read().
    void learn(const VerifiedMesh& surface, const Mesh::Mark& mark, std::vector<Sphere> balls);

    /// Whether the change can be copied by each of these turns. The surface must have been its own image under the
    /// turn, colours and masks included, with nothing else in the patch's turned balls, and no two copies may overlap.
    /// Precondition: the octree is up to date. Cost: the patch.
    bool match(const VerifiedMesh& surface, std::span<const Turn> turns);
    /// Copies the change by one of the turns, each once, in one transaction. False if the result does not verify: then
    /// nothing has changed. Precondition: match().
    bool place(VerifiedMesh& surface, std::size_t turn);

    /// Returns the image of a vertex under the turn of the last place(); noSlot if the vertex is neither part of the
    /// change nor beside it.
    Slot imageOf(Slot v) const;
    /// Returns the vertices that have images.
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
    std::vector<std::vector<Slot>> m_places; ///< for each turn, images by position among the patch's vertices
    std::vector<Slot> m_images;              ///< for the turn of find() or place()
    std::vector<char> m_seen;                ///< by face of the patch, for find()
    SlotSet m_matched;                       ///< faces of the surface that are images of the patch's
    SlotSet m_claimed;                       ///< vertices in what changed, here and at each image so far
};
} // namespace core
