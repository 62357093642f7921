// A dab's change in another sector:
//   learn    the journal tells which faces went, which came, and which vertices moved; with the ring of faces around
//   them they are the patch match    the patch as it was before, turned: found face by face in the surface, the first
//   vertex by the octree, the rest from neighbour to
//            neighbour
//   claim    no vertex of what changes there has been changed by this dab already
//   write    faces are exchanged, vertices moved and coloured as here
//   verify   as every change is

#include "core/sculpt/patch_copy.h"

#include "core/sculpt/select/region.h"

#include <algorithm>

namespace core
{
namespace
{
bool isSameFace(const Triangle& a, const Triangle& b)
{
    return a == b || a == Triangle{b[1], b[2], b[0]} || a == Triangle{b[2], b[0], b[1]};
}
} // namespace

Slot vertexAt(const VerifiedMesh& surface, const Vec3f& p)
{
    const Mesh& mesh = surface.mesh();
    const LatticePoint at = mesh.lattice().toLattice(p);
    Slot found = noSlot;
    surface.octree().query({at, at}, [&](Slot f) {
        for (Slot corner : mesh.corners(f)) {
            if (mesh.point(corner) == p)
                found = corner;
        }
    });
    return found;
}

void PatchCopy::learn(const VerifiedMesh& surface, const Mesh::Mark& mark, std::vector<Sphere> balls)
{
    const Mesh& mesh = surface.mesh();
    m_balls = std::move(balls);
    readVertices(mesh, mark);
    readFaces(mesh, mark);
    collectPatch(mesh);
    for (const Sphere& ball : m_balls) {
        for (Slot f : facesIn(mesh, surface.octree(), latticeBox(mesh.lattice(), ball)))
            addUnlinkedFace(mesh, f);
    }
    sortSides();
    m_claimed.clear();
    for (Slot i = 0; i < m_ownCount; ++i)
        m_claimed.add(m_vertices.slots()[i]);
    for (const Triangle& t : m_come) {
        for (Slot v : t)
            m_claimed.add(v);
    }
}

void PatchCopy::readVertices(const Mesh& mesh, const Mesh::Mark& mark)
{
    m_touched.clear();
    m_states.clear();
    m_moved.clear();
    m_marked.clear();
    for (const VertexImage& image : mesh.vertexImagesSince(mark)) {
        const Slot v = image.slot;
        if (m_touched.contains(v))
            continue;
        m_touched.add(v);
        m_states.push_back({image.point, image.color, image.mask, image.live});
        if (!image.live || v >= mesh.slots().vertices || !mesh.isVertex(v))
            continue;
        if (mesh.point(v) != image.point)
            m_moved.push_back(v);
        if (mesh.color(v) != image.color || mesh.mask(v) != image.mask)
            m_marked.push_back(v);
    }
}

void PatchCopy::readFaces(const Mesh& mesh, const Mesh::Mark& mark)
{
    m_relinked.clear();
    m_unlinked.clear();
    m_gone.clear();
    m_come.clear();
    for (const FaceImage& image : mesh.faceImagesSince(mark)) {
        const bool isLive = image.slot < mesh.slots().faces && mesh.isFace(image.slot);
        const bool isKept = isLive && image.live() && isSameFace(image.corners, mesh.corners(image.slot));
        if (isKept || !m_relinked.add(image.slot))
            continue;
        if (image.live())
            m_gone.push_back(image.corners);
        if (isLive)
            m_come.push_back(mesh.corners(image.slot));
    }
}

/// What went, and what was around what moved; then the ring around it.
void PatchCopy::collectPatch(const Mesh& mesh)
{
    m_patch.clear();
    m_vertices.clear();
    std::ranges::for_each(m_gone, [&](const Triangle& t) { addPatchFace(t); });
    for (const std::vector<Slot>* changed : {&m_moved, &m_marked}) {
        for (Slot v : *changed)
            addUnlinked(mesh, v);
    }
    m_ownCount = static_cast<Slot>(m_vertices.size());
    for (Slot i = 0; i < m_ownCount; ++i) {
        if (const Slot v = m_vertices.slots()[i]; v < mesh.slots().vertices && mesh.isVertex(v))
            addUnlinked(mesh, v);
    }
}

/// Faces around v that are linked as before.
void PatchCopy::addUnlinked(const Mesh& mesh, Slot v)
{
    mesh.forEachOutgoing(v, [&](Slot h) { addUnlinkedFace(mesh, mesh.face(h)); });
}

void PatchCopy::addUnlinkedFace(const Mesh& mesh, Slot f)
{
    if (!m_relinked.contains(f) && m_unlinked.add(f))
        addPatchFace(mesh.corners(f));
}

void PatchCopy::addPatchFace(const Triangle& corners)
{
    m_patch.push_back(corners);
    for (Slot v : corners)
        m_vertices.add(v);
}

void PatchCopy::sortSides()
{
    m_sides.clear();
    for (std::size_t i = 0; i < m_patch.size(); ++i) {
        const Triangle& t = m_patch[i];
        for (std::size_t k = 0; k < 3; ++k)
            m_sides.push_back({t[k], t[(k + 1) % 3], i});
    }
    std::ranges::sort(m_sides);
}

PatchCopy::State PatchCopy::before(const Mesh& mesh, Slot v) const
{
    const Slot i = m_touched.find(v);
    return i == noSlot ? State{mesh.point(v), mesh.color(v), mesh.mask(v), true} : m_states[i];
}

bool PatchCopy::isImage(const Mesh& mesh, const Turn& turn, Slot image, Slot v) const
{
    const State state = before(mesh, v);
    return mesh.point(image) == turn * state.point && mesh.color(image) == state.color &&
           mesh.mask(image) == state.mask;
}

/// From each face to its neighbours: then all but the first vertices of a component are found next to an image.
bool PatchCopy::matchAt(const VerifiedMesh& surface, const Turn& turn)
{
    const Mesh& mesh = surface.mesh();
    m_images.assign(m_vertices.size(), noSlot);
    m_seen.assign(m_patch.size(), 0);
    m_matched.clear();
    for (std::size_t first = 0; first < m_patch.size(); ++first) {
        if (m_seen[first])
            continue;
        for (Slot v : m_patch[first]) {
            if (image(v) == noSlot)
                image(v) = vertexAt(surface, turn * before(mesh, v).point);
            if (image(v) == noSlot || !isImage(mesh, turn, image(v), v))
                return false;
        }
        if (!matchFrom(mesh, turn, first))
            return false;
    }
    return isAllMatched(surface, turn);
}

/// What lies where the balls are turned to has come from there.
bool PatchCopy::isAllMatched(const VerifiedMesh& surface, const Turn& turn) const
{
    const Mesh& mesh = surface.mesh();
    return std::ranges::all_of(m_balls, [&](const Sphere& ball) {
        const LatticeBox box = latticeBox(mesh.lattice(), {turn * ball.center, ball.radius});
        return std::ranges::all_of(facesIn(mesh, surface.octree(), box), [&](Slot f) { return m_matched.contains(f); });
    });
}

bool PatchCopy::matchFrom(const Mesh& mesh, const Turn& turn, std::size_t face)
{
    std::vector<std::size_t> front = {face};
    while (!front.empty()) {
        const Triangle t = m_patch[front.back()];
        const bool isSeen = m_seen[front.back()];
        m_seen[front.back()] = 1;
        front.pop_back();
        if (isSeen)
            continue;
        const Slot h = mesh.findHalfedge(image(t[0]), image(t[1]));
        if (h == noSlot || mesh.to(mesh.next(h)) != image(t[2]) || !matchAcross(mesh, turn, t, front))
            return false;
        m_matched.add(mesh.face(h));
    }
    return true;
}

/// The corners beyond the face's sides.
bool PatchCopy::matchAcross(const Mesh& mesh, const Turn& turn, const Triangle& corners,
                            std::vector<std::size_t>& front)
{
    for (std::size_t k = 0; k < 3; ++k) {
        const Slot a = corners[(k + 1) % 3], b = corners[k];
        const auto side = std::ranges::lower_bound(m_sides, Side{a, b, 0});
        if (side == m_sides.end() || side->from != a || side->to != b || m_seen[side->face])
            continue;
        const Triangle& t = m_patch[side->face];
        const Slot beyond = t[0] != a && t[0] != b ? t[0] : t[1] != a && t[1] != b ? t[1] : t[2];
        if (image(beyond) == noSlot) {
            const Slot h = mesh.findHalfedge(image(a), image(b));
            if (h == noSlot || !isImage(mesh, turn, mesh.to(mesh.next(h)), beyond))
                return false;
            image(beyond) = mesh.to(mesh.next(h));
        }
        front.push_back(side->face);
    }
    return true;
}

bool PatchCopy::claim()
{
    const auto images = std::span(m_images).first(m_ownCount);
    if (std::ranges::any_of(images, [&](Slot v) { return m_claimed.contains(v); }))
        return false;
    for (Slot v : images)
        m_claimed.add(v);
    return true;
}

/// Vertices that came here come there; all others are there.
Surgery PatchCopy::exchange(const Mesh& mesh, const Turn& turn) const
{
    Surgery surgery;
    surgery.near = m_ownCount > 0 ? m_images[0] : m_come[0][0];
    const auto imageOf = [&](Slot v) { return m_images[m_vertices.position(v)]; };
    for (const Triangle& t : m_gone)
        surgery.removed.push_back(mesh.face(mesh.findHalfedge(imageOf(t[0]), imageOf(t[1]))));
    SparseIndex come;
    const auto corner = [&](Slot v) {
        if (const Slot i = m_vertices.find(v); i < m_ownCount)
            return m_images[i];
        if (!come.contains(v))
            surgery.vertices.push_back({turn * mesh.point(v), mesh.color(v), noSlot, mesh.mask(v)});
        return Surgery::newVertex(come.add(v));
    };
    for (const Triangle& t : m_come)
        surgery.faces.push_back({corner(t[0]), corner(t[1]), corner(t[2])});
    return surgery;
}

void PatchCopy::write(Mesh& mesh, const Turn& turn)
{
    if (!m_gone.empty() || !m_come.empty()) {
        const Surgery surgery = exchange(mesh, turn);
        const std::vector<Slot> created = mesh.replaceFaces(surgery);
        for (std::size_t i = 0; i < m_come.size(); ++i) {
            for (std::size_t k = 0; k < 3; ++k) {
                if (const Slot corner = surgery.faces[i][k]; Surgery::isNew(corner)) {
                    m_vertices.add(m_come[i][k]);
                    m_images.resize(m_vertices.size());
                    image(m_come[i][k]) = created[Surgery::newIndex(corner)];
                }
            }
        }
    }
    for (Slot v : m_moved)
        mesh.setPoint(image(v), turn * mesh.point(v));
    for (Slot v : m_marked) {
        mesh.setColor(image(v), mesh.color(v));
        mesh.setMask(image(v), mesh.mask(v));
    }
}

bool PatchCopy::match(const VerifiedMesh& surface, std::span<const Turn> turns)
{
    m_turns.assign(turns.begin(), turns.end());
    m_places.clear();
    for (const Turn& turn : turns) {
        if (!matchAt(surface, turn) || !claim())
            return false;
        m_places.push_back(m_images);
    }
    return true;
}

bool PatchCopy::place(VerifiedMesh& surface, std::size_t index)
{
    if (isNothing())
        return true;
    const Turn& turn = m_turns[index];
    m_images = std::move(m_places[index]);
    m_images.resize(m_vertices.size(), noSlot); // others may have come meanwhile, elsewhere
    Mesh& mesh = surface.mesh();
    if (!isMarking())
        return surface.tryOperation([&] { write(mesh, turn); });
    const Mesh::Mark mark = mesh.mark();
    write(mesh, turn);
    surface.commitUnverified(mark);
    return true;
}

Slot PatchCopy::imageOf(Slot v) const
{
    const Slot i = m_vertices.find(v);
    return i == noSlot ? noSlot : m_images[i];
}
} // namespace core
