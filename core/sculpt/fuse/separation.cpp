#include "core/sculpt/fuse/separation.h"

#include "core/sculpt/fuse/cycle_cut.h"

#include <algorithm>

namespace core
{
namespace
{
/// A neck is cut when the edges around it are shorter than this together, in terms of d. One that a join has left is
/// cut if no ball of diameter d fits through: 3 sqrt(3) of an even triangle.
constexpr double neckPerimeter = 3, jointPerimeter = 5.2;
/// The gaps to try between the two sides of a cut neck, in terms of d.
constexpr double neckGaps[] = {0.5, 0.1};
/// A speck: a component smaller than this, in terms of the brush's d; one of few faces may be a little larger.
constexpr double speckSize = 2, crumbSize = 4;
constexpr std::size_t speckFaces = 64, fewFaces = 16;
/// The faces of a shred at most, and how many times as many the part has at least from which it came off.
constexpr std::size_t maxShredFaces = 2048, bodyPerShred = 10;
/// A void that a join has closed is filled if it is smaller than this, in terms of the brush's d.
constexpr double voidSize = 5;
constexpr std::size_t voidFaces = 256;

/// Six times the volume that the faces enclose, in mm3: negative for a void.
double volume6(const Mesh& mesh, std::span<const Slot> faces)
{
    double sum = 0;
    for (Slot f : faces) {
        const Triangle& t = mesh.corners(f);
        const auto point = [&](Slot v) -> Vec3 { return mesh.point(v).cast<double>(); };
        sum += point(t[0]).dot(point(t[1]).cross(point(t[2])));
    }
    return sum;
}

/// Returns the third vertex of the shortest cycle of three edges that holds this edge and is no face; noSlot if there
/// is none of that length.
Slot neckAt(const Mesh& mesh, const VertexPair& edge, double maxPerimeter)
{
    const Slot a = edge[0], b = edge[1];
    const Slot h = mesh.findHalfedge(a, b);
    const Slot left = mesh.to(mesh.next(h)), right = mesh.to(mesh.next(h ^ 1));
    const auto length = [&](Slot v, Slot w) {
        return (mesh.point(v).cast<double>() - mesh.point(w).cast<double>()).norm();
    };
    double shortest = maxPerimeter;
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
    return third;
}
} // namespace

std::uint64_t Separation::separate(VerifiedMesh& surface, Region& region, const std::vector<VertexPair>& blocked,
                                   const EdgeBounds& bounds)
{
    std::uint64_t separations = 0;
    const Mesh& mesh = surface.mesh();
    for (const VertexPair& edge : blocked) {
        if (!mesh.isVertex(edge[0]) || !mesh.isVertex(edge[1]) || mesh.findHalfedge(edge[0], edge[1]) == noSlot)
            continue;
        separations += cutNeck(surface, region, edge, neckPerimeter * bounds.minimum, bounds) ||
                       removeSpeck(surface, region, edge[0], bounds);
    }
    return separations;
}

std::uint64_t Separation::cutCycles(VerifiedMesh& surface, Region& region, const std::vector<Slot>& vertices,
                                    const EdgeBounds& bounds, const RestLengths* rest)
{
    const Mesh& mesh = surface.mesh();
    const auto minimum = [&](Slot v, Slot w) {
        return rest ? std::min({bounds.minimum, rest->of(v), rest->of(w)}) : bounds.minimum;
    };
    const MirrorMap* mirror = m_surgery.mirror();
    std::uint64_t cuts = 0;
    std::vector<Slot> neighbours;
    for (Slot v : vertices) {
        if (!mesh.isVertex(v) || (mirror && !mirror->isInHalf(v)))
            continue;
        neighbours.clear();
        mesh.forEachOutgoing(v, [&](Slot h) { neighbours.push_back(mesh.to(h)); });
        for (Slot other : neighbours) {
            if (!mesh.isVertex(v))
                break;
            if (mesh.isVertex(other) && mesh.findHalfedge(v, other) != noSlot)
                cuts += cutNeck(surface, region, {v, other}, jointPerimeter * minimum(v, other), bounds);
        }
    }
    for (Slot v : vertices) {
        if (mesh.isVertex(v) && (!mirror || mirror->isInHalf(v)))
            cuts += removeSpeck(surface, region, v, bounds, Also::Voids);
    }
    return cuts;
}

bool Separation::cutNeck(VerifiedMesh& surface, Region& region, const VertexPair& edge, double maxPerimeter,
                         const EdgeBounds& bounds)
{
    const Mesh& mesh = surface.mesh();
    const Slot third = neckAt(mesh, edge, maxPerimeter);
    if (third == noSlot || !m_surgery.mayTry(edge[0]) || !m_surgery.mayTry(edge[1]))
        return false;
    const Triangle cycle = {edge[0], edge[1], third};
    const Vec3 middle = (mesh.point(cycle[0]) + mesh.point(cycle[1]) + mesh.point(cycle[2])).cast<double>() / 3;
    for (double gap : neckGaps) {
        const std::optional<Surgery> neck = cutCycle(mesh, cycle, DrawBack::AlongAxis, gap * bounds.minimum);
        const std::optional<Surgery> surgery = isOwnImage(mesh, cycle) ? neck : m_surgery.withItsImage(surface, neck);
        if (!surgery)
            return false;
        if (const auto created = m_surgery.operate(surface, region, *surgery)) {
            m_necks.push_back(middle);
            // a copy of the cycle's vertex on each side
            removeSpecks(surface, region, {(*created)[0], (*created)[3]}, bounds);
            removeShred(surface, region, (*created)[0], (*created)[3], bounds);
            removeShred(surface, region, (*created)[3], (*created)[0], bounds);
            return true;
        }
    }
    m_surgery.countFailure(edge[0]);
    m_surgery.countFailure(edge[1]);
    return false;
}

/// Whether the neck lies on the mirror's plane, and no face around it reaches across.
bool Separation::isOwnImage(const Mesh& mesh, const Triangle& cycle) const
{
    const MirrorMap* mirror = m_surgery.mirror();
    if (!mirror)
        return false;
    bool isClear = true;
    for (Slot v : cycle) {
        isClear = isClear && mirror->isOnPlane(v);
        mesh.forEachOutgoing(v, [&](Slot h) { isClear = isClear && !mirror->isAcross(mesh.next(h) / 2); });
    }
    return isClear;
}

void Separation::removeSpecks(VerifiedMesh& surface, Region& region, const std::vector<Slot>& vertices,
                              const EdgeBounds& bounds)
{
    for (Slot v : vertices) {
        if (surface.mesh().isVertex(v)) // else it went with one before
            removeSpeck(surface, region, v, bounds);
    }
}

/// Removes the component of a vertex, if it is a shred and the one that it came off is far larger.
void Separation::removeShred(VerifiedMesh& surface, Region& region, Slot vertex, Slot body, const EdgeBounds& bounds)
{
    const Mesh& mesh = surface.mesh();
    if (m_shredSize == 0 || !mesh.isVertex(vertex) || !mesh.isVertex(body))
        return;
    const auto facesUpTo = [&](Slot v, std::size_t max) {
        SlotSet& found = region.scratch();
        found.clear();
        found.add(mesh.face(mesh.outgoing(v)));
        for (std::size_t i = 0; i < found.size() && found.size() <= max; ++i) {
            Slot h = mesh.faceHalfedge(found.slots()[i]);
            for (int k = 0; k < 3; ++k, h = mesh.next(h))
                found.add(mesh.face(h ^ 1));
        }
        return found.size();
    };
    const std::size_t faces = facesUpTo(vertex, maxShredFaces);
    if (faces <= maxShredFaces && facesUpTo(body, bodyPerShred * faces) > bodyPerShred * faces)
        removeSpeck(surface, region, vertex, bounds, Also::Shreds);
}

/// Removes the component of a vertex, if it is small and not all there is: a speck, a void or a shred. (One that holds
/// another is not sound to remove.)
bool Separation::removeSpeck(VerifiedMesh& surface, Region& region, Slot vertex, const EdgeBounds& bounds, Also also)
{
    const Mesh& mesh = surface.mesh();
    LatticeBox box;
    SlotSet& found = region.scratch();
    found.clear();
    found.add(mesh.face(mesh.outgoing(vertex)));
    const double d = bounds.minimum / m_detailShare;
    const auto size = [&] { return (box.max - box.min).cast<double>().maxCoeff() * mesh.lattice().unit(); };
    const auto isSpeck = [&] {
        return found.size() <= speckFaces && size() <= (found.size() < fewFaces ? crumbSize : speckSize) * d;
    };
    const auto mayBeVoid = [&] { return also == Also::Voids && found.size() <= voidFaces && size() <= voidSize * d; };
    const auto isShred = [&] { return also == Also::Shreds && size() <= m_shredSize && found.size() <= maxShredFaces; };
    for (std::size_t i = 0; i < found.size(); ++i) {
        Slot h = mesh.faceHalfedge(found.slots()[i]);
        for (int k = 0; k < 3; ++k, h = mesh.next(h)) {
            found.add(mesh.face(h ^ 1));
            box.extend(mesh.latticePoint(mesh.to(h)));
        }
        if (!isSpeck() && !isShred() && !mayBeVoid()) // and stays so: both only grow
            return false;
    }
    if (!isSpeck() && !isShred() && volume6(mesh, found.slots()) >= 0)
        return false;
    Surgery surgery;
    surgery.removed = found.slots();
    surgery.near = vertex;
    const std::optional<Surgery> removal = m_surgery.withItsImage(surface, surgery);
    return removal && removal->removed.size() < mesh.live().faces &&
           m_surgery.operate(surface, region, *removal).has_value();
}
} // namespace core
