#include "core/sculpt/copy/changed_patch.h"

#include "core/geometry/lattice_box.h"

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

void ChangedPatch::read(const Mesh& mesh, const FaceOctree& octree, const Mesh::Mark& mark, std::vector<Sphere> balls)
{
    m_balls = std::move(balls);
    readVertices(mesh, mark);
    readFaces(mesh, mark);
    collectFaces(mesh);
    for (const Sphere& ball : m_balls) {
        for (Slot f : facesIn(mesh, octree, latticeBox(mesh.lattice(), ball)))
            addUnlinked(mesh, f);
    }
    sortSides();
}

void ChangedPatch::readVertices(const Mesh& mesh, const Mesh::Mark& mark)
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

void ChangedPatch::readFaces(const Mesh& mesh, const Mesh::Mark& mark)
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

/// Collects the removed and relinked faces and the faces around changed vertices; then the ring of faces around these.
void ChangedPatch::collectFaces(const Mesh& mesh)
{
    m_faces.clear();
    m_vertices.clear();
    std::ranges::for_each(m_gone, [&](const Triangle& t) { addFace(t); });
    for (const std::vector<Slot>* changed : {&m_moved, &m_marked}) {
        for (Slot v : *changed)
            addUnlinkedAround(mesh, v);
    }
    m_changedCount = static_cast<Slot>(m_vertices.size());
    for (Slot i = 0; i < m_changedCount; ++i) {
        if (const Slot v = m_vertices.slots()[i]; v < mesh.slots().vertices && mesh.isVertex(v))
            addUnlinkedAround(mesh, v);
    }
}

/// Adds the faces around v that have kept their corners.
void ChangedPatch::addUnlinkedAround(const Mesh& mesh, Slot v)
{
    mesh.forEachOutgoing(v, [&](Slot h) { addUnlinked(mesh, mesh.face(h)); });
}

void ChangedPatch::addUnlinked(const Mesh& mesh, Slot f)
{
    if (!m_relinked.contains(f) && m_unlinked.add(f))
        addFace(mesh.corners(f));
}

void ChangedPatch::addFace(const Triangle& corners)
{
    m_faces.push_back(corners);
    for (Slot v : corners)
        m_vertices.add(v);
}

void ChangedPatch::sortSides()
{
    m_sides.clear();
    for (std::size_t i = 0; i < m_faces.size(); ++i) {
        const Triangle& t = m_faces[i];
        for (std::size_t k = 0; k < 3; ++k)
            m_sides.push_back({t[k], t[(k + 1) % 3], i});
    }
    std::ranges::sort(m_sides);
}

ChangedPatch::VertexState ChangedPatch::before(const Mesh& mesh, Slot v) const
{
    const Slot i = m_touched.find(v);
    return i == noSlot ? VertexState{mesh.point(v), mesh.color(v), mesh.mask(v), true} : m_states[i];
}

std::size_t ChangedPatch::faceAt(Slot from, Slot to) const
{
    const auto side = std::ranges::lower_bound(m_sides, Side{from, to, 0});
    return side != m_sides.end() && side->from == from && side->to == to ? side->face : m_faces.size();
}
} // namespace core
