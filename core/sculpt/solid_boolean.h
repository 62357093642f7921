#pragma once

#include "core/analysis/self_intersection.h"
#include "core/mesh/surgery.h"
#include "core/repair/triangle_soup.h"
#include "core/sculpt/verify/verified_mesh.h"

#include <optional>

namespace core
{
enum class BooleanOperation { Unite, Subtract };

/// Computes the union or difference of the solid that a mesh bounds and another solid whose surface crosses the mesh.
/// Exact: both surfaces are cut along the curves in which they meet (core/repair/arrangement.h), and the pieces that
/// bound the result are kept. Looks only at the mesh's faces near the other solid. Cost: these faces, plus the square
/// of the number of faces that meet any one face.
class SolidBoolean
{
public:
    /// `solid`: closed shells, which may cross each other, with points on the mesh's lattice. Each of its points gets
    /// the colour of the nearest point of the model.
    SolidBoolean(const VerifiedMesh& surface, const TriangleMesh& solid);

    /// Returns whether the two surfaces meet.
    bool areCrossing() const;
    /// Returns the surgery that turns the mesh into the result. New vertices are rounded to the lattice, so the result
    /// must still be verified. Returns nothing if faces are coplanar, or if the surfaces touch without crossing; then
    /// the solid has to be shifted by some lattice units. Precondition: areCrossing().
    std::optional<Surgery> surgery(BooleanOperation operation) const;
    /// Returns the faces of the mesh near the solid.
    const std::vector<Slot>& candidates() const { return m_candidates; }

private:
    struct Pieces;

    Rgb colorNear(const LatticePoint& p, std::size_t count) const;
    bool isSolidFace(Slot face) const { return face >= m_candidates.size(); }
    Surgery surgeryOf(const Pieces& pieces, const std::vector<bool>& isKept, BooleanOperation operation) const;

    const VerifiedMesh& m_surface;
    std::vector<Slot> m_candidates;
    std::vector<Slot> m_vertices; ///< mesh vertices of the candidates
    repair::TriangleSoup m_soup;  ///< the candidates, followed by the solid's faces
    std::vector<FacePair> m_pairs;
};
} // namespace core
