#pragma once

#include "core/analysis/self_intersection.h"
#include "core/mesh/surgery.h"
#include "core/repair/triangle_soup.h"
#include "core/sculpt/verify/verified_mesh.h"

#include <optional>

namespace core
{
enum class BooleanOperation { Unite, Subtract };

/// The boolean operation of the solid that a mesh bounds with another whose surface crosses its, exact: both surfaces
/// are cut along the curves in which they meet (core/repair/arrangement.h), and what bounds the result is kept. Looks
/// at the faces near the other solid only. Cost: those faces, and the square of what meets one of them.
class SolidBoolean
{
public:
    /// `solid`: closed shells, which may meet each other, of points on the mesh's lattice. Its points take the colour
    /// of the model near them.
    SolidBoolean(const VerifiedMesh& surface, const TriangleMesh& solid);

    /// Whether the two surfaces meet.
    bool areCrossing() const;
    /// Returns the exchange of faces, with the places of new vertices rounded to the lattice, so that it is still to be
    /// verified. Nothing where faces lie in one plane, or the surfaces touch without crossing: then the solid has to
    /// be shifted by some lattice units. Precondition: areCrossing().
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
    std::vector<Slot> m_vertices; ///< of the candidates
    repair::TriangleSoup m_soup;  ///< the candidates, and after them the solid's faces
    std::vector<FacePair> m_pairs;
};
} // namespace core
