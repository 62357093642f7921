#pragma once

#include "core/sculpt/copy/patch_match.h"

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
    /// turn, and no two copies may overlap. Precondition and cost: see PatchMatch::find().
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
    bool claim(std::span<const Slot> vertices);
    Surgery exchange(const Mesh& mesh, const Turn& turn) const;
    void write(Mesh& mesh, const Turn& turn);
    Slot& image(Slot v) { return m_images[m_patch.vertices().position(v)]; }

    ChangedPatch m_patch;
    PatchMatch m_match;
    std::vector<Turn> m_turns;
    std::vector<std::vector<Slot>> m_places; ///< for each turn, images by position among the patch's vertices
    std::vector<Slot> m_images;              ///< for the turn of place()
    SlotSet m_claimed;                       ///< vertices in what changed, here and at each image so far
};
} // namespace core
