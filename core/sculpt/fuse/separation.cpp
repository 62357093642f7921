// The last step of fusion.cpp, where an edge that is too short can no longer be collapsed: a neck three edges around is
// cut, a speck is removed.

#include "core/sculpt/fuse/fusion.h"

#include "core/sculpt/fuse/ring_join.h"

namespace core
{
namespace
{
/// A neck is cut when the edges around it are shorter than this together, in terms of d.
constexpr double neckPerimeter = 3;
/// The gaps to try between the two sides of a cut neck, in terms of d.
constexpr double neckGaps[] = {0.5, 0.1};
/// A speck: a component smaller than this, in terms of the brush's d; one of few faces may be a little larger.
constexpr double speckSize = 2, crumbSize = 4;
constexpr std::size_t speckFaces = 64, fewFaces = 16;
} // namespace

FusionCounts TopologyFusion::separate(VerifiedMesh& surface, Region& region, const std::vector<VertexPair>& blocked,
                                      const EdgeBounds& bounds)
{
    FusionCounts counts;
    const Mesh& mesh = surface.mesh();
    for (const VertexPair& edge : blocked) {
        if (!mesh.isVertex(edge[0]) || !mesh.isVertex(edge[1]) || mesh.findHalfedge(edge[0], edge[1]) == noSlot)
            continue;
        counts.separations += cut(surface, region, edge, bounds) || removeSpeck(surface, region, edge[0], bounds);
    }
    return counts;
}

/// And no face around it reaches across.
bool TopologyFusion::isOnPlane(const Mesh& mesh, const Triangle& cycle) const
{
    bool clear = true;
    for (Slot v : cycle) {
        clear = clear && m_mirror->isOnPlane(v);
        mesh.forEachOutgoing(v, [&](Slot h) { clear = clear && !m_mirror->isAcross(mesh.next(h) / 2); });
    }
    return clear;
}

/// Through the shortest cycle of three edges that holds this one and is no face.
bool TopologyFusion::cut(VerifiedMesh& surface, Region& region, const VertexPair& edge, const EdgeBounds& bounds)
{
    const Mesh& mesh = surface.mesh();
    const auto [a, b] = edge;
    const Slot h = mesh.findHalfedge(a, b);
    const Slot left = mesh.to(mesh.next(h)), right = mesh.to(mesh.next(h ^ 1));
    const auto length = [&](Slot v, Slot w) {
        return (mesh.point(v).cast<double>() - mesh.point(w).cast<double>()).norm();
    };
    double shortest = neckPerimeter * bounds.minimum;
    Slot third = noSlot;
    mesh.forEachOutgoing(a, [&](Slot g) {
        const Slot c = mesh.to(g);
        if (c == b || c == left || c == right || mesh.findHalfedge(b, c) == noSlot)
            return;
        const double around = length(a, b) + length(b, c) + length(c, a);
        if (around < shortest || (around == shortest && c < third)) {
            shortest = around;
            third = c;
        }
    });
    if (third == noSlot || !mayTry(a) || !mayTry(b))
        return false;
    const Triangle cycle = {a, b, third};
    for (double gap : neckGaps) {
        const std::optional<Surgery> neck = cutNeck(mesh, cycle, gap * bounds.minimum);
        const bool isOwnImage = m_mirror && isOnPlane(mesh, cycle);
        const std::optional<Surgery> surgery = isOwnImage ? neck : completed(surface, neck);
        if (!surgery)
            return false;
        if (const auto created = operate(surface, region, *surgery)) {
            removeSpecks(surface, region, {(*created)[0], (*created)[3]},
                         bounds); // a copy of the cycle's vertex on each side
            return true;
        }
    }
    countFailure(a);
    countFailure(b);
    return false;
}

void TopologyFusion::removeSpecks(VerifiedMesh& surface, Region& region, const std::vector<Slot>& vertices,
                                  const EdgeBounds& bounds)
{
    for (Slot v : vertices) {
        if (surface.mesh().isVertex(v)) // else it went with one before
            removeSpeck(surface, region, v, bounds);
    }
}

/// The component of a vertex, if it is small and not all there is. (One that holds another is not sound to remove.)
bool TopologyFusion::removeSpeck(VerifiedMesh& surface, Region& region, Slot vertex, const EdgeBounds& bounds)
{
    const Mesh& mesh = surface.mesh();
    Surgery surgery;
    LatticeBox box;
    SlotSet& found = region.scratch();
    found.clear();
    found.add(mesh.face(mesh.outgoing(vertex)));
    const auto isTooLarge = [&] { // and stays so: both only grow
        const double size = (box.max - box.min).cast<double>().maxCoeff() * mesh.lattice().unit();
        return found.size() > speckFaces ||
               size > (found.size() < fewFaces ? crumbSize : speckSize) * bounds.minimum / m_detailShare;
    };
    for (std::size_t i = 0; i < found.size(); ++i) {
        Slot h = mesh.faceHalfedge(found.slots()[i]);
        for (int k = 0; k < 3; ++k, h = mesh.next(h)) {
            found.add(mesh.face(h ^ 1));
            box.extend(mesh.latticePoint(mesh.to(h)));
        }
        if (isTooLarge())
            return false;
    }
    surgery.removed = found.slots();
    surgery.near = vertex;
    const std::optional<Surgery> removal = completed(surface, surgery);
    return removal && removal->removed.size() < mesh.live().faces && operate(surface, region, *removal).has_value();
}
} // namespace core
