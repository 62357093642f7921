// The exact local check of a change (core/README.md, "A dab"):
//   1. dirty faces:  the relinked faces in the journal, and the faces around moved vertices      (dirty_neighbourhood)
//   2. links:        every relinked face must be linked correctly
//   3. partners:     all faces that meet a box of the change, which covers the dirty faces where they are and where
//                    they were. Unconnected parts of the change have a box each, as on both sides of a mirror
//                                                                                                (dirty_neighbourhood)
//   4. Patch:        one certificate for all these faces, or one for each patch around dirty faces  (patch_components)
//      Stars:        for patches without a certificate: certificates of their vertices' stars      (patch_certificate)
//                    and exact tests of pairs of disjoint faces
//      Pairs:        exact tests of neighbouring pairs too, where a star has no certificate
//   5. nesting:      a shell completely inside a box must still face the right way at its nesting depth

#include "core/sculpt/verify/verifier.h"

#include "core/analysis/shell_orientation.h"
#include "core/geometry/box_pairs.h"
#include "core/geometry/triangle_intersection.h"
#include "core/util/parallel.h"

#include <algorithm>

namespace core
{
namespace
{
/// Faces, or stars, in a parallel chunk: about ten microseconds of work, so that small dabs run on one core.
constexpr std::size_t facesPerBoundary = 512, starsPerChunk = 128;

void sortUniquely(std::vector<Slot>& faces)
{
    std::ranges::sort(faces);
    faces.erase(std::ranges::unique(faces).begin(), faces.end());
}

IntegerDirection directionOfChange(const DirtyNeighbourhood& neighbourhood)
{
    Vec3 sum = Vec3::Zero();
    for (Slot i = 0; i < neighbourhood.dirtyCount(); ++i)
        sum += neighbourhood.normal(i);
    return integerDirection(sum);
}

/// Returns the half-edges of the gathered faces whose opposite face was not gathered.
std::vector<BoundaryEdge> boundaryOf(const Mesh& mesh, const DirtyNeighbourhood& neighbourhood)
{
    return joinChunks<std::vector<BoundaryEdge>>(
        neighbourhood.size(), facesPerBoundary,
        [&](std::size_t begin, std::size_t end, std::vector<BoundaryEdge>& boundary) {
            for (std::size_t i = begin; i < end; ++i) {
                Slot h = mesh.faceHalfedge(neighbourhood.faces()[i]);
                for (int k = 0; k < 3; ++k, h = mesh.next(h)) {
                    if (!neighbourhood.contains(mesh.face(h ^ 1)))
                        boundary.push_back(boundaryEdge(mesh, h));
                }
            }
        });
}

/// Returns whether the face's half-edges are linked correctly: in a cycle, to the face, to its corners, and to a live
/// neighbour.
bool isLinked(const Mesh& mesh, Slot f, const Triangle& corners)
{
    Slot h = mesh.faceHalfedge(f);
    const auto corner = std::ranges::find(corners, mesh.from(h));
    bool linked = corner != corners.end();
    for (int k = 0; linked && k < 3; ++k) {
        const std::size_t at = static_cast<std::size_t>(corner - corners.begin() + k) % 3;
        linked = mesh.face(h) == f && mesh.from(h) == corners[at] && mesh.isVertex(corners[at]) && mesh.isEdge(h / 2) &&
                 mesh.isFace(mesh.face(h ^ 1)) && mesh.prev(mesh.next(h)) == h;
        h = mesh.next(h);
    }
    return linked && h == mesh.faceHalfedge(f);
}
} // namespace

VerifyResult Verifier::verify(const Mesh& mesh, const FaceOctree& octree, const TouchedSlots& touched)
{
    m_result = {};
    m_neighbourhood.collectDirty(mesh, touched);
    if (m_neighbourhood.dirtyCount() == 0 && touched.faces.empty())
        return m_result;
    m_neighbourhood.gather(mesh, octree, touched);
    findMislinked(mesh);
    if (m_result.ok() && certifyAll(mesh))
        return m_result;
    m_neighbourhood.buildIndex();
    findDegenerate();
    if (m_result.ok()) {
        m_components.find(mesh, m_neighbourhood);
        if (!m_components.areCertified() || m_components.size() > 1) {
            testPairs(mesh);
            if (m_result.ok())
                checkNesting(mesh, octree);
        }
    }
    sortUniquely(m_result.badFaces);
    return m_result;
}

/// The neighbourhood gathered by verify() for the larger motion contains all faces that the smaller motion can reach.
std::vector<Slot> Verifier::recheck(const Mesh& mesh, std::span<const Slot> vertices)
{
    // indices in the neighbourhood: first the faces at the vertices, then the faces whose boxes meet the box of these
    SparseIndex near;
    std::vector<Slot> bad;
    LatticeBox box;
    for (Slot v : vertices) {
        mesh.forEachOutgoing(v, [&](Slot h) {
            const Slot index = m_neighbourhood.indexOf(mesh.face(h));
            if (index == noSlot || near.contains(index))
                return;
            near.add(index);
            m_neighbourhood.reread(mesh, index);
            box.extend(m_neighbourhood.boxes()[index]);
            if (m_neighbourhood.isDegenerate(index))
                bad.push_back(m_neighbourhood.faces()[index]);
        });
    }
    if (!bad.empty())
        return bad;
    const Slot changed = static_cast<Slot>(near.size());
    const std::span<const LatticeBox> allBoxes = m_neighbourhood.boxes();
    for (Slot index = 0; index < m_neighbourhood.size(); ++index) {
        if (box.meets(allBoxes[index]))
            near.add(index);
    }
    std::vector<LatticeBox> boxes;
    for (Slot index : near.slots())
        boxes.push_back(allBoxes[index]);
    m_stars.clear();
    const auto meet = [&](Slot i, Slot j) { return meetBadly(near.slots()[i], near.slots()[j]); };
    for (const auto& [i, j] : BoxPairs(boxes, changed).those(meet)) {
        bad.push_back(m_neighbourhood.faces()[near.slots()[i]]);
        bad.push_back(m_neighbourhood.faces()[near.slots()[j]]);
    }
    sortUniquely(bad);
    return bad;
}

/// Returns whether one certificate covers all gathered faces, as it does after most changes. If so, no face is
/// degenerate, and the faces are one patch with a boundary: a second patch would have a boundary of its own.
bool Verifier::certifyAll(const Mesh& mesh)
{
    if (m_neighbourhood.dirtyCount() == 0)
        return false;
    const IntegerDirection direction = directionOfChange(m_neighbourhood);
    if (!arePositive(m_neighbourhood.shapes(), direction))
        return false;
    std::vector<BoundaryEdge> boundary = boundaryOf(mesh, m_neighbourhood);
    return isSimpleLoop(boundary, direction);
}

void Verifier::findMislinked(const Mesh& mesh)
{
    for (Slot i = 0; i < m_neighbourhood.relinkedCount(); ++i) {
        if (!isLinked(mesh, m_neighbourhood.faces()[i], m_neighbourhood.shape(i).corners))
            addBad(i);
    }
}

void Verifier::findDegenerate()
{
    for (Slot i = 0; i < m_neighbourhood.dirtyCount(); ++i) {
        if (m_neighbourhood.isDegenerate(i))
            addBad(i);
    }
}

/// Tests all pairs of faces whose boxes meet and of which at least one is dirty, except pairs within a certified patch.
void Verifier::testPairs(const Mesh& mesh)
{
    m_stars.clear();
    if (!m_components.areCertified())
        m_result.tier = certifyStars(mesh) ? VerifyTier::Stars : VerifyTier::Pairs;
    const auto isBad = [&](Slot i, Slot j) { return !m_components.areInOneCertified(i, j) && meetBadly(i, j); };
    for (const auto& [i, j] : BoxPairs(m_neighbourhood.boxes(), m_neighbourhood.dirtyCount()).those(isBad)) {
        addBad(i);
        addBad(j);
    }
}

/// Tries to certify the stars of all corners of dirty faces in uncertified patches. Returns whether all were certified.
bool Verifier::certifyStars(const Mesh& mesh)
{
    for (Slot i = 0; i < m_neighbourhood.dirtyCount(); ++i) {
        if (m_components.isCertified(m_components.of(i)))
            continue;
        for (Slot v : m_neighbourhood.shape(i).corners)
            m_stars.add(v);
    }
    m_isStarCertified.resize(m_stars.size());
    forEachChunk(m_stars.size(), starsPerChunk, [&](std::size_t, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            m_isStarCertified[i] = certifyStar(mesh, m_stars.slots()[i]);
    });
    return std::ranges::find(m_isStarCertified, 0) == m_isStarCertified.end();
}

/// Returns whether two faces meet anywhere except at shared vertices and edges.
bool Verifier::meetBadly(Slot i, Slot j) const
{
    const PatchFace& s = m_neighbourhood.shape(i);
    const PatchFace& t = m_neighbourhood.shape(j);
    for (Slot v : s.corners) {
        const bool shared = v == t.corners[0] || v == t.corners[1] || v == t.corners[2];
        if (shared && isStarCertified(v))
            return false;
    }
    return trianglesIntersect<LatticePredicates>({s.corners, s.points}, {t.corners, t.points});
}

/// Checks the shells that are completely inside a box of the change. Such a shell may have been turned over, enclosed
/// by another shell, or released from one, without any two faces meeting now.
void Verifier::checkNesting(const Mesh& mesh, const FaceOctree& octree)
{
    for (Slot component = 0; component < m_components.size(); ++component) {
        if (!m_components.isClosed(component) || isNestedWell(mesh, octree, component))
            continue;
        for (Slot i = 0; i < m_neighbourhood.size(); ++i) {
            if (m_components.of(i) == component)
                addBad(i);
        }
    }
}

/// Returns whether the shell faces outward at even nesting depth, inward at odd depth.
bool Verifier::isNestedWell(const Mesh& mesh, const FaceOctree& octree, Slot component) const
{
    ShellOrientation probe;
    for (Slot i = 0; i < m_neighbourhood.size(); ++i) {
        if (m_components.of(i) == component)
            probe.addFace(m_neighbourhood.shape(i).points);
    }
    octree.query(probe.column(), [&](Slot f) {
        if (!mesh.isFace(f))
            return;
        const Slot index = m_neighbourhood.indexOf(f);
        const bool isOwn = index != noSlot && m_components.of(index) == component;
        if (index < m_neighbourhood.dirtyCount() || isOwn)
            return;
        const Triangle& t = mesh.corners(f);
        probe.castAt({mesh.latticePoint(t[0]), mesh.latticePoint(t[1]), mesh.latticePoint(t[2])});
    });
    for (Slot i = 0; i < m_neighbourhood.dirtyCount(); ++i) {
        if (m_components.of(i) != component)
            probe.castAt(m_neighbourhood.shape(i).points);
    }
    return probe.isCorrectlyOriented();
}
} // namespace core
