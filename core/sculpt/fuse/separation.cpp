#include "core/sculpt/fuse/separation.h"

#include "core/sculpt/fuse/cycle_cut.h"

#include <algorithm>

namespace core
{
namespace
{
/// Largest perimeter, in d, of a cycle of three edges at which a neck is cut. jointPerimeter applies to necks left by
/// joins: 3 sqrt(3) is the perimeter of an equilateral triangle through which a ball of diameter d just fits.
constexpr double neckPerimeter = 3, jointPerimeter = 5.2;
/// Gaps to try between the two sides of a cut neck, in d.
constexpr double neckGaps[] = {0.5, 0.1};
/// Largest extents of a speck, in d of the brush: speckSize for a component of up to speckFaces faces, crumbSize if it
/// has fewer than fewFaces faces.
constexpr double speckSize = 2, crumbSize = 4;
constexpr std::size_t speckFaces = 64, fewFaces = 16;
/// maxShredFaces: largest number of faces of a shred, a small part that comes off at a neck during a drag.
/// bodyPerShred: a shred is removed only if the remaining part has more than this many times its faces.
constexpr std::size_t maxShredFaces = 2048, bodyPerShred = 10;
/// Largest extent, in d of the brush, and largest number of faces of a void that is filled after a join has closed it
/// off.
constexpr double voidSize = 5;
constexpr std::size_t voidFaces = 256;

/// Returns six times the volume that the faces enclose, mm3; negative for a void.
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

/// Returns the third vertex of the shortest cycle of three edges that contains this edge and is not a face; noSlot if
/// there is none shorter than maxPerimeter (mm).
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
            // created[0] and created[3] are copies of one vertex of the cycle, on its two sides
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

/// Returns whether the neck's cycle is in the mirror plane and no face around it crosses the plane.
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
        if (surface.mesh().isVertex(v)) // it may have been removed with an earlier speck
            removeSpeck(surface, region, v, bounds);
    }
}

/// Removes the component of `vertex` if it is a shred (a small part that came off at a neck during a drag) and the
/// component of `body`, from which it came off, is much larger.
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

/// Removes the component of a vertex if it is small: a speck, a void or a shred. Keeps it if it is the whole model.
/// (Removing a component that encloses another one does not verify.)
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
        // the component is too large already, and grows with each face found
        if (!isSpeck() && !isShred() && !mayBeVoid())
            return false;
    }
    if (!isSpeck() && !isShred() && volume6(mesh, found.slots()) >= 0)
        return false;
    Surgery surgery;
    surgery.removed = found.slots();
    surgery.nearby = vertex;
    const std::optional<Surgery> removal = m_surgery.withItsImage(surface, surgery);
    return removal && removal->removed.size() < mesh.live().faces &&
           m_surgery.operate(surface, region, *removal).has_value();
}
} // namespace core
