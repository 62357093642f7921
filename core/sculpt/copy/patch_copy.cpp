// A dab's change in another sector:
//   learn    the journal tells which faces went, which came, and which vertices moved; with a ring of faces around
//            them they are the patch                                                                 changed_patch
//   match    the patch as it was before, turned, is found face by face in the surface                patch_match
//   claim    no vertex of the patch's image has been changed by this dab already
//   write    faces are exchanged, vertices moved and coloured as here
//   verify   as every change is

#include "core/sculpt/copy/patch_copy.h"

#include <algorithm>

namespace core
{
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
        if (!m_match.find(surface, m_patch, turn) || !claim(std::span(m_match.images()).first(m_patch.changedCount())))
            return false;
        m_places.push_back(m_match.images());
    }
    return true;
}

/// False if one of the vertices has been claimed already.
bool PatchCopy::claim(std::span<const Slot> vertices)
{
    if (std::ranges::any_of(vertices, [&](Slot v) { return m_claimed.contains(v); }))
        return false;
    for (Slot v : vertices)
        m_claimed.add(v);
    return true;
}

/// Returns the exchange there. Vertices that came here are to come there; all others are there.
Surgery PatchCopy::exchange(const Mesh& mesh, const Turn& turn) const
{
    Surgery surgery;
    surgery.near = m_patch.changedCount() > 0 ? m_images[0] : m_patch.come()[0][0];
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
    m_images.resize(m_patch.vertices().size(), noSlot); // others may have come meanwhile, elsewhere
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
