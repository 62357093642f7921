// The exact local check of a change (DESIGN section 3, step 5):
//   1. dirty faces:  those the journal says were relinked, and those around a vertex that moved
//   2. linked:       each rightly
//   3. partners:     every face that meets a box of the dirty ones, where they are and where they were: one box, or one
//   for each of
//                    those parts of the change that nothing connects, as on both sides of a plane of symmetry
//   4. tier a:       one certificate for all of these, or for each connected patch around dirty faces
//      tier b:       certificates for the stars of the vertices of one that has none, exact tests of the disjoint pairs
//      tier c:       exact tests of neighbouring pairs too, where a star has no certificate
//   5. nesting:      a shell wholly inside a box must still face the right way at its depth

#include "core/sculpt/verify/verifier.h"

#include "core/analysis/shell_orientation.h"
#include "core/geometry/box_clusters.h"
#include "core/geometry/box_pairs.h"
#include "core/util/parallel.h"

#include <algorithm>

namespace core
{
namespace
{
/// What a core takes at a time: some ten microseconds of work, so that small dabs do not wake the others.
constexpr std::size_t facesPerChunk = 512, starsPerChunk = 128;

BoundaryEdge boundaryEdge(const Mesh& mesh, Slot h)
{
    const Slot from = mesh.from(h), to = mesh.to(h);
    return {from, to, mesh.latticePoint(from), mesh.latticePoint(to)};
}

/// Exact: integers. Its length is twice the area.
Vec3 normalOf(const PatchFace& face)
{
    const Vec3 ab = (face.points[1] - face.points[0]).cast<double>(),
               ac = (face.points[2] - face.points[0]).cast<double>();
    return ab.cross(ac);
}
} // namespace

VerifyResult Verifier::verify(const Mesh& mesh, const FaceOctree& octree, const TouchedSlots& touched)
{
    m_result = {};
    collectDirty(mesh, touched);
    if (m_dirtyCount == 0 && touched.faces.empty())
        return m_result;
    gather(mesh, octree, touched);
    findMislinked(mesh);
    if (m_result.ok() && certifyAll(mesh))
        return m_result;
    notePlaces();
    findDegenerate();
    if (m_result.ok()) {
        findComponents(mesh);
        if (!isCertified() || m_components.size() > 1) {
            testPairs(mesh);
            if (m_result.ok())
                checkNesting(mesh, octree);
        }
    }
    std::ranges::sort(m_result.badFaces);
    m_result.badFaces.erase(std::ranges::unique(m_result.badFaces).begin(), m_result.badFaces.end());
    return m_result;
}

/// What was gathered holds all that the smaller change can meet.
std::vector<Slot> Verifier::recheck(const Mesh& mesh, std::span<const Slot> vertices)
{
    SparseIndex near; // by place among the gathered: the faces at the vertices, then what meets the box of these
    std::vector<Slot> bad;
    LatticeBox box;
    for (Slot v : vertices) {
        mesh.forEachOutgoing(v, [&](Slot h) {
            const Slot place = m_places.find(mesh.face(h));
            if (place == noSlot || near.contains(place))
                return;
            near.add(place);
            readFaces(mesh, std::span(&m_gathered.slots()[place], 1), place);
            box.extend(m_boxes[place]);
            const auto& p = m_shapes[place].points;
            if (LatticePredicates::collinear(p[0], p[1], p[2]))
                bad.push_back(m_gathered.slots()[place]);
        });
    }
    if (!bad.empty())
        return bad;
    const Slot changed = static_cast<Slot>(near.size());
    for (Slot place = 0; place < m_gathered.size(); ++place) {
        if (box.meets(m_boxes[place]))
            near.add(place);
    }
    std::vector<LatticeBox> boxes;
    for (Slot place : near.slots())
        boxes.push_back(m_boxes[place]);
    m_stars.clear();
    for (const auto& [i, j] :
         BoxPairs(boxes, changed).those([&](Slot i, Slot j) { return meetBadly(near.slots()[i], near.slots()[j]); })) {
        bad.push_back(m_gathered.slots()[near.slots()[i]]);
        bad.push_back(m_gathered.slots()[near.slots()[j]]);
    }
    std::ranges::sort(bad);
    bad.erase(std::ranges::unique(bad).begin(), bad.end());
    return bad;
}

void Verifier::collectDirty(const Mesh& mesh, const TouchedSlots& touched)
{
    m_gathered.clear();
    for (Slot f : touched.faces) {
        if (mesh.isFace(f))
            m_gathered.add(f);
    }
    m_relinkedCount = static_cast<Slot>(m_gathered.size());
    for (Slot v : touched.vertices) {
        if (mesh.isVertex(v))
            mesh.forEachOutgoing(v, [&](Slot h) { m_gathered.add(mesh.face(h)); });
    }
    m_dirtyCount = static_cast<Slot>(m_gathered.size());
    readFaces(mesh, m_gathered.slots(), 0);
}

/// The boxes of the change hold where its faces are and where they were: what lay between has been swept over. A shell
/// that is swallowed or let out is so by a connected part of the surface as it was and as it is, and lies in the box of
/// that.
void Verifier::gather(const Mesh& mesh, const FaceOctree& octree, const TouchedSlots& touched)
{
    LatticeBox all;
    for (const LatticeBox& box : dirtyBoxes())
        all.extend(box);
    for (const TouchedSlots::Place& place : touched.before)
        all.extend(mesh.lattice().toLattice(place.point));
    std::vector<LatticeBox> parts;
    if (separatingAxis(dirtyBoxes(), all) == 3) { // nearly always
        parts.push_back(all);
    } else {
        std::vector<LatticeBox> boxes = boxesOf(mesh, touched); // none, of faces that have come and gone
        addClusters(boxes, parts);
    }
    for (const LatticeBox& part : parts) {
        for (Slot f : facesIn(mesh, octree, part))
            m_gathered.add(f); // a dirty one is known already
    }
    readFaces(mesh, std::span(m_gathered.slots()).subspan(m_dirtyCount), m_dirtyCount);
}

/// Of the faces that changed: where each was and is, or, if it was relinked, of what it was and of what it is.
std::vector<LatticeBox> Verifier::boxesOf(const Mesh& mesh, const TouchedSlots& touched)
{
    m_moved.clear();
    for (const TouchedSlots::Place& place : touched.before)
        m_moved.add(place.vertex);
    const auto extend = [&](LatticeBox& box, const Triangle& corners) {
        for (Slot v : corners) {
            const Slot place = m_moved.find(v);
            box.extend(place == noSlot ? mesh.latticePoint(v) : mesh.lattice().toLattice(touched.before[place].point));
        }
    };
    std::vector<LatticeBox> boxes(dirtyBoxes().begin(), dirtyBoxes().end());
    for (Slot i = m_relinkedCount; i < m_dirtyCount; ++i)
        extend(boxes[i], m_shapes[i].corners);
    for (const Triangle& corners : touched.facesBefore)
        extend(boxes.emplace_back(), corners);
    return boxes;
}

/// Their shapes and boxes, to stand from `first` on.
void Verifier::readFaces(const Mesh& mesh, std::span<const Slot> faces, std::size_t first)
{
    if (first + faces.size() > m_shapes.size()) {
        m_shapes.resize(first + faces.size());
        m_boxes.resize(first + faces.size());
    }
    forEachChunk(faces.size(), facesPerChunk, [&](std::size_t, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const Triangle& t = mesh.corners(faces[i]);
            const LatticePoint a = mesh.latticePoint(t[0]), b = mesh.latticePoint(t[1]), c = mesh.latticePoint(t[2]);
            m_shapes[first + i] = {t, {a, b, c}};
            m_boxes[first + i] = {a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c)};
        }
    });
}

/// Most changes leave all that is near them one sheet that a single direction sees from above. (Then none of the faces
/// is degenerate, and they are one component with an edge: a second one would have a loop of its own.)
bool Verifier::certifyAll(const Mesh& mesh)
{
    if (m_dirtyCount == 0)
        return false;
    const IntegerDirection direction = directionOfChange();
    if (!arePositive(std::span(m_shapes).first(m_gathered.size()), direction))
        return false;
    collectBoundary(mesh);
    return isSimpleLoop(m_boundary, direction);
}

IntegerDirection Verifier::directionOfChange() const
{
    Vec3 sum = Vec3::Zero();
    for (Slot i = 0; i < m_dirtyCount; ++i)
        sum += normalOf(m_shapes[i]);
    return integerDirection(sum);
}

/// The half-edges of all gathered faces that have none of these on the other side.
void Verifier::collectBoundary(const Mesh& mesh)
{
    m_boundary = joinChunks<std::vector<BoundaryEdge>>(
        m_gathered.size(), facesPerChunk, [&](std::size_t begin, std::size_t end, std::vector<BoundaryEdge>& boundary) {
            for (std::size_t i = begin; i < end; ++i) {
                Slot h = mesh.faceHalfedge(m_gathered.slots()[i]);
                for (int k = 0; k < 3; ++k, h = mesh.next(h)) {
                    if (!m_gathered.contains(mesh.face(h ^ 1)))
                        boundary.push_back(boundaryEdge(mesh, h));
                }
            }
        });
}

void Verifier::findMislinked(const Mesh& mesh)
{
    for (Slot i = 0; i < m_relinkedCount; ++i) {
        if (!isLinked(mesh, i))
            m_result.badFaces.push_back(m_gathered.slots()[i]);
    }
}

void Verifier::findDegenerate()
{
    for (Slot i = 0; i < m_dirtyCount; ++i) {
        const auto& p = m_shapes[i].points;
        if (LatticePredicates::collinear(p[0], p[1], p[2]))
            m_result.badFaces.push_back(m_gathered.slots()[i]);
    }
}

/// Links are checked where they changed: around the loop, to the face, to the corners, and across to a live neighbour.
bool Verifier::isLinked(const Mesh& mesh, Slot local) const
{
    const Slot f = m_gathered.slots()[local];
    const Triangle& corners = m_shapes[local].corners;
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

void Verifier::notePlaces()
{
    m_places.clear();
    for (Slot f : m_gathered.slots())
        m_places.add(f);
}

/// Labels the gathered faces by component; those of the dirty faces come first.
void Verifier::findComponents(const Mesh& mesh)
{
    m_component.assign(m_gathered.size(), noSlot);
    m_components.clear();
    m_dirtyComponents = 0;
    for (Slot seed = 0; seed < m_gathered.size(); ++seed) {
        if (m_component[seed] == noSlot)
            addComponent(mesh, seed);
        if (seed < m_dirtyCount)
            m_dirtyComponents = static_cast<Slot>(m_components.size());
    }
}

/// With its certificate, where it has dirty faces and gets one.
void Verifier::addComponent(const Mesh& mesh, Slot seed)
{
    const Slot number = static_cast<Slot>(m_components.size());
    Component& component = m_components.emplace_back();
    Vec3 sum = Vec3::Zero(); // of the dirty faces' normals
    m_patch.clear();
    m_boundary.clear();
    m_component[seed] = number;
    m_front.assign(1, seed);
    while (!m_front.empty()) {
        const Slot at = m_front.back();
        m_front.pop_back();
        if (at < m_dirtyCount)
            sum += normalOf(m_shapes[at]);
        if (seed < m_dirtyCount)
            m_patch.push_back(m_shapes[at]);
        Slot h = mesh.faceHalfedge(m_gathered.slots()[at]);
        for (int k = 0; k < 3; ++k, h = mesh.next(h)) {
            const Slot next = m_places.find(mesh.face(h ^ 1));
            if (next == noSlot) {
                component.isClosed = false;
                if (seed < m_dirtyCount)
                    m_boundary.push_back(boundaryEdge(mesh, h));
            } else if (m_component[next] == noSlot) {
                m_component[next] = number;
                m_front.push_back(next);
            }
        }
    }
    component.isCertified =
        seed < m_dirtyCount && !component.isClosed && certifyPatch(m_patch, m_boundary, integerDirection(sum));
}

/// Each patch in itself; and there is one.
bool Verifier::isCertified() const
{
    return m_dirtyComponents > 0 &&
           std::ranges::all_of(std::span(m_components).first(m_dirtyComponents), &Component::isCertified);
}

/// Tests the pairs with at least one dirty face whose boxes meet, but those within a certified patch.
void Verifier::testPairs(const Mesh& mesh)
{
    m_stars.clear();
    m_starCertified.clear();
    if (!isCertified())
        m_result.tier = certifyStars(mesh) ? VerifyTier::Stars : VerifyTier::Pairs;
    const std::vector<BoxPairs::Pair> bad =
        BoxPairs(std::span(m_boxes).first(m_gathered.size()), m_dirtyCount).those([&](Slot i, Slot j) {
            return !areInOneCertified(i, j) && meetBadly(i, j);
        });
    for (const auto& [i, j] : bad) {
        m_result.badFaces.push_back(m_gathered.slots()[i]);
        m_result.badFaces.push_back(m_gathered.slots()[j]);
    }
}

/// Of all corners of dirty faces in patches that have none themselves. False if one has no certificate.
bool Verifier::certifyStars(const Mesh& mesh)
{
    for (Slot i = 0; i < m_dirtyCount; ++i) {
        if (m_components[m_component[i]].isCertified)
            continue;
        for (Slot v : m_shapes[i].corners)
            m_stars.add(v);
    }
    m_starCertified.resize(m_stars.size());
    forEachChunk(m_stars.size(), starsPerChunk, [&](std::size_t, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            m_starCertified[i] = certifyStar(mesh, m_stars.slots()[i]);
    });
    return std::ranges::find(m_starCertified, 0) == m_starCertified.end();
}

bool Verifier::areInOneCertified(Slot i, Slot j) const
{
    return m_component[i] == m_component[j] && m_components[m_component[i]].isCertified;
}

/// Whether they meet where they may not.
bool Verifier::meetBadly(Slot i, Slot j) const
{
    const PatchFace& s = m_shapes[i];
    const PatchFace& t = m_shapes[j];
    for (Slot v : s.corners) {
        const bool shared = v == t.corners[0] || v == t.corners[1] || v == t.corners[2];
        if (shared && m_stars.contains(v) && m_starCertified[m_stars.position(v)])
            return false;
    }
    return trianglesIntersect<LatticePredicates>({s.corners, s.points}, {t.corners, t.points});
}

/// A shell wholly inside a box of the change may have been turned over, swallowed or let out without any two faces
/// meeting now.
void Verifier::checkNesting(const Mesh& mesh, const FaceOctree& octree)
{
    for (Slot component = 0; component < m_components.size(); ++component) {
        if (!m_components[component].isClosed)
            continue;
        ShellOrientation probe;
        for (Slot i = 0; i < m_gathered.size(); ++i) {
            if (m_component[i] == component)
                probe.addFace(m_shapes[i].points);
        }
        const auto isOwn = [&](Slot f) {
            return m_places.contains(f) && m_component[m_places.position(f)] == component;
        };
        octree.query(probe.column(), [&](Slot f) {
            if (!mesh.isFace(f) || isDirty(f) || isOwn(f))
                return;
            const Triangle& t = mesh.corners(f);
            probe.castAt({mesh.latticePoint(t[0]), mesh.latticePoint(t[1]), mesh.latticePoint(t[2])});
        });
        for (Slot i = 0; i < m_dirtyCount; ++i) {
            if (m_component[i] != component)
                probe.castAt(m_shapes[i].points);
        }
        if (probe.isCorrectlyOriented())
            continue;
        for (Slot i = 0; i < m_gathered.size(); ++i) {
            if (m_component[i] == component)
                m_result.badFaces.push_back(m_gathered.slots()[i]);
        }
    }
}
} // namespace core
