#pragma once

#include "core/sculpt/copy/changed_patch.h"
#include "core/sculpt/verify/verified_mesh.h"
#include "core/stroke/radial_symmetry.h"

namespace core
{
/// Returns the vertex at that lattice point, or noSlot. Precondition: the octree is up to date.
Slot vertexAt(const VerifiedMesh& surface, const Vec3f& p);

/// Finds the image of a patch under a turn, bit for bit: the first vertex by the octree, the others from neighbour to
/// neighbour. Owns scratch memory.
class PatchMatch
{
public:
    /// Finds the image of the patch as it was before it changed. False if the surface is not its image there, colours
    /// and masks included; or if something else lies in the patch's turned balls. Precondition: the octree is up to
    /// date. Cost: the patch.
    bool find(const VerifiedMesh& surface, const ChangedPatch& patch, const Turn& turn);

    /// Returns the images of the patch's vertices, by position among them.
    const std::vector<Slot>& images() const { return m_images; }

private:
    struct Search
    {
        const Mesh& mesh;
        const ChangedPatch& patch;
        const Turn& turn;
    };
    bool matchVertex(const VerifiedMesh& surface, const Search& search, Slot v);
    bool matchFrom(const Search& search, std::size_t face);
    bool matchAcross(const Search& search, const Triangle& corners, std::vector<std::size_t>& front);
    bool isAllMatched(const VerifiedMesh& surface, const Search& search) const;
    Slot& image(const Search& search, Slot v) { return m_images[search.patch.vertices().position(v)]; }

    std::vector<Slot> m_images;
    std::vector<char> m_seen; ///< by face of the patch
    SlotSet m_matched;        ///< faces of the surface that are images of the patch's
};
} // namespace core
