#pragma once

#include "core/area/view_area.h"
#include "core/mesh/mesh.h"

namespace core
{
/// The pieces that a cut takes from a mesh, each with its own share of the exchange of faces. A piece is what hangs
/// together by exchanged faces: pieces that share a face of the mesh, or a corner, count as one, and so does a piece
/// with the voids in it.
///
/// A piece is seen first if no other piece covers it, not even in part: no line of sight through the area meets another
/// piece and then this one. If each piece is covered by another one, those are seen first that come nearest to the eye.
/// Covering is judged along the lines of sight through the corners and middles of the mesh's faces. Pieces in the
/// area's mirror image are judged from the eye's mirror image. Example: a curve across an arm before a body divides arm
/// and body into pieces; only the arm's is seen first, even if the body is seen beside it.
class CutPieces
{
public:
    /// Precondition: the arguments outlive this; isSurgeryOk(mesh, whole); `whole` cuts along the area's curve. Cost:
    /// O(exchanged faces); with voids, the solid angles of each larger piece from each of their faces.
    CutPieces(const Mesh& mesh, const Surgery& whole);

    std::size_t count() const { return m_count; }
    /// Returns for each piece whether it is seen first. Cost: two lines of sight for each removed face and corner.
    std::vector<bool> seenFirst(const ViewArea& area) const;
    /// Returns the exchange that takes only these pieces.
    Surgery taking(const std::vector<bool>& pieces) const;

private:
    Slot keyOf(Slot corner) const;
    void join();
    void joinVoids();
    TriangleMesh boundaryOf(Slot piece) const;

    const Mesh& m_mesh;
    const Surgery& m_whole;
    std::vector<Slot> m_pieceOf; ///< piece by vertex slot, then by new vertex; noSlot: not exchanged
    std::size_t m_count = 0;
};
} // namespace core
