// Copies a dab's change to another sector of a radially symmetric stroke:
//   learn    the journal lists the removed, added and relinked faces and the moved vertices; together with a ring of
//            faces around them they are the patch                                                     (changed_patch)
//   match    the patch as it was before the dab, turned into that sector, is searched face by face in the surface
//   claim    the patch's image must not contain a vertex that this dab or a copy has changed already
//   write    faces are replaced, vertices moved and coloured as in the patch
//   verify   the copy is verified like any other change

#include "core/sculpt/copy/patch_copy.h"

#include "core/geometry/lattice_box.h"
#include "core/mesh/surface_query.h"

#include <algorithm>

namespace core
{
namespace
{
bool isImage(const Mesh& mesh, const ChangedPatch& patch, const Turn& turn, Slot image, Slot v)
{
    const ChangedPatch::VertexState state = patch.before(mesh, v);
    return mesh.point(image) == turn * state.point && mesh.color(image) == state.color &&
           mesh.mask(image) == state.mask && !mesh.isHidden(image);
}
} // namespace

void PatchCopy::learn(const VerifiedMesh& surface, const Mesh::Mark& mark, std::vector<Sphere> balls)
{
    m_patch.read(surface.mesh(), surface.octree(), mark, std::move(balls));
    m_claimed.clear();
    for (Slot i = 0; i < m_patch.changedCount(); ++i)
        m_claimed.add(vertices()[i]);
    for (const Triangle& t : m_patch.come()) {
        for (Slot v : t)
            m_claimed.add(v);
    }
}

bool PatchCopy::match(const VerifiedMesh& surface, std::span<const Turn> turns)
{
    m_turns.assign(turns.begin(), turns.end());
    m_places.clear();
    for (const Turn& turn : turns) {
        if (!find(surface, turn) || !claim(std::span(m_images).first(m_patch.changedCount())))
            return false;
        m_places.push_back(m_images);
    }
    return true;
}

/// Finds the exact image of the patch as it was before the change. Looks up the first face's corners in the octree, and
/// all others from neighbour to neighbour.
bool PatchCopy::find(const VerifiedMesh& surface, const Turn& turn)
{
    m_images.assign(m_patch.vertices().size(), noSlot);
    m_seen.assign(m_patch.faces().size(), 0);
    m_matched.clear();
    for (std::size_t first = 0; first < m_patch.faces().size(); ++first) {
        if (m_seen[first])
            continue;
        for (Slot v : m_patch.faces()[first]) {
            if (!matchVertex(surface, turn, v))
                return false;
        }
        if (!matchFrom(surface.mesh(), turn, first))
            return false;
    }
    return isAllMatched(surface, turn);
}

/// Matches a vertex of the first face of a connected part, by looking up its turned position.
bool PatchCopy::matchVertex(const VerifiedMesh& surface, const Turn& turn, Slot v)
{
    const Mesh& mesh = surface.mesh();
    Slot& found = image(v);
    if (found == noSlot)
        found = vertexAt(mesh, surface.octree(), turn * m_patch.before(mesh, v).point);
    return found != noSlot && isImage(mesh, m_patch, turn, found, v);
}

/// Matches all faces connected to the given face, from neighbour to neighbour.
bool PatchCopy::matchFrom(const Mesh& mesh, const Turn& turn, std::size_t face)
{
    std::vector<std::size_t> front = {face};
    while (!front.empty()) {
        const Triangle t = m_patch.faces()[front.back()];
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

/// Matches the far corners of the faces across the face's three sides, and appends these faces to `front`.
bool PatchCopy::matchAcross(const Mesh& mesh, const Turn& turn, const Triangle& corners,
                            std::vector<std::size_t>& front)
{
    const std::vector<Triangle>& faces = m_patch.faces();
    for (std::size_t k = 0; k < 3; ++k) {
        const Slot a = corners[(k + 1) % 3], b = corners[k];
        const std::size_t face = m_patch.faceAt(a, b);
        if (face == faces.size() || m_seen[face])
            continue;
        const Triangle& t = faces[face];
        const Slot beyond = t[0] != a && t[0] != b ? t[0] : t[1] != a && t[1] != b ? t[1] : t[2];
        if (image(beyond) == noSlot) {
            const Slot h = mesh.findHalfedge(image(a), image(b));
            if (h == noSlot || !isImage(mesh, m_patch, turn, mesh.to(mesh.next(h)), beyond))
                return false;
            image(beyond) = mesh.to(mesh.next(h));
        }
        front.push_back(face);
    }
    return true;
}

/// Returns whether every face in the turned balls is the image of a face of the patch.
bool PatchCopy::isAllMatched(const VerifiedMesh& surface, const Turn& turn) const
{
    const Mesh& mesh = surface.mesh();
    return std::ranges::all_of(m_patch.balls(), [&](const Sphere& ball) {
        const LatticeBox box = latticeBox(mesh.lattice(), {turn * ball.center, ball.radius});
        return std::ranges::all_of(facesIn(mesh, surface.octree(), box), [&](Slot f) { return m_matched.contains(f); });
    });
}

/// Marks the vertices as used. Returns false, without marking any, if one of them is marked already.
bool PatchCopy::claim(std::span<const Slot> vertices)
{
    if (std::ranges::any_of(vertices, [&](Slot v) { return m_claimed.contains(v); }))
        return false;
    for (Slot v : vertices)
        m_claimed.add(v);
    return true;
}

/// Returns the surgery that repeats the change at the turned place. Vertices that the change created are created there
/// too; all others exist there.
Surgery PatchCopy::exchange(const Mesh& mesh, const Turn& turn) const
{
    Surgery surgery;
    surgery.nearby = m_patch.changedCount() > 0 ? m_images[0] : m_patch.come()[0][0];
    const auto imageOf = [&](Slot v) { return m_images[m_patch.vertices().position(v)]; };
    for (const Triangle& t : m_patch.gone())
        surgery.removed.push_back(mesh.face(mesh.findHalfedge(imageOf(t[0]), imageOf(t[1]))));
    SparseIndex come;
    const auto corner = [&](Slot v) {
        if (const Slot i = m_patch.vertices().find(v); i < m_patch.changedCount())
            return m_images[i];
        if (!come.contains(v))
            surgery.vertices.push_back({turn * mesh.point(v), mesh.color(v), noSlot, mesh.mask(v)});
        return Surgery::newVertex(come.add(v));
    };
    for (const Triangle& t : m_patch.come())
        surgery.faces.push_back({corner(t[0]), corner(t[1]), corner(t[2])});
    return surgery;
}

void PatchCopy::write(Mesh& mesh, const Turn& turn)
{
    if (!m_patch.gone().empty() || !m_patch.come().empty()) {
        const Surgery surgery = exchange(mesh, turn);
        const std::vector<Slot> created = mesh.replaceFaces(surgery);
        for (std::size_t i = 0; i < m_patch.come().size(); ++i) {
            for (std::size_t k = 0; k < 3; ++k) {
                if (const Slot corner = surgery.faces[i][k]; Surgery::isNew(corner)) {
                    m_patch.add(m_patch.come()[i][k]);
                    m_images.resize(m_patch.vertices().size());
                    image(m_patch.come()[i][k]) = created[Surgery::newIndex(corner)];
                }
            }
        }
    }
    for (Slot v : m_patch.moved())
        mesh.setPoint(image(v), turn * mesh.point(v));
    for (Slot v : m_patch.marked()) {
        mesh.setColor(image(v), mesh.color(v));
        mesh.setMask(image(v), mesh.mask(v));
    }
}

bool PatchCopy::place(VerifiedMesh& surface, std::size_t index)
{
    if (isNothing())
        return true;
    const Turn& turn = m_turns[index];
    m_images = std::move(m_places[index]);
    m_images.resize(m_patch.vertices().size(), noSlot); // copies to other sectors may have added vertices meanwhile
    Mesh& mesh = surface.mesh();
    if (!m_patch.isMarking())
        return surface.tryOperation([&] { write(mesh, turn); });
    const Mesh::Mark mark = mesh.mark();
    write(mesh, turn);
    surface.commitUnverified(mark);
    return true;
}

Slot PatchCopy::imageOf(Slot v) const
{
    const Slot i = m_patch.vertices().find(v);
    return i == noSlot ? noSlot : m_images[i];
}
} // namespace core
