#include "core/sculpt/verify/verified_mesh.h"

#include "core/util/phase_timer.h"

namespace core
{
bool VerifiedMesh::verify(const Mesh::Mark& mark)
{
    const PhaseTimer timer(m_verifyMs);
    const TouchedSlots touched = m_mesh.touchedSince(mark);
    if (!isSound(touched))
        return false;
    m_maxDirtyFaces = std::max(m_maxDirtyFaces, static_cast<Slot>(m_verifier.dirtyFaces().size()));
    m_mesh.commit(mark);
    m_octree.removeDead(m_mesh, touched.faces);
    m_octree.place(m_mesh, m_verifier.dirtyFaces(), m_verifier.dirtyBoxes());
    m_dirtySlots.add(m_mesh, touched, m_verifier.dirtyFaces());
    return true;
}

bool VerifiedMesh::recheck(std::span<const Slot> vertices)
{
    const PhaseTimer timer(m_verifyMs);
    if (!m_verification)
        return true;
    std::vector<Slot> bad = m_verifier.recheck(m_mesh, vertices);
    if (bad.empty())
        return true;
    m_badFaces = std::move(bad);
    return false;
}

bool VerifiedMesh::isSound(const TouchedSlots& touched)
{
    if (!m_verification) {
        m_verifier.collectDirty(m_mesh, touched);
        return true;
    }
    VerifyResult result = m_verifier.verify(m_mesh, m_octree, touched);
    if (!result.ok()) {
        m_badFaces = std::move(result.badFaces);
        return false;
    }
    ++m_tiers[static_cast<std::size_t>(result.tier)];
    return true;
}

bool VerifiedMesh::tryOperation(const std::function<void()>& operation)
{
    const Mesh::Mark mark = m_mesh.mark();
    operation();
    if (verify(mark))
        return true;
    m_mesh.rollback(mark);
    return false;
}

void VerifiedMesh::commitUnverified(const Mesh::Mark& mark)
{
    const TouchedSlots touched = m_mesh.touchedSince(mark);
    m_mesh.commit(mark);
    m_dirtySlots.add(m_mesh, touched, {});
}

void VerifiedMesh::follow(const MeshDelta& swapped)
{
    if (swapped.frame.lattice != m_mesh.lattice()) {
        const PartId active = m_octree.activePart();
        m_octree = FaceOctree(m_mesh);
        m_octree.activate(active);
    }
    TouchedSlots touched;
    m_swappedFaces.clear();
    for (const FaceImage& image : swapped.faces) {
        touched.faces.push_back(image.slot);
        if (image.slot < m_mesh.slots().faces && m_mesh.isFace(image.slot))
            m_swappedFaces.add(image.slot);
    }
    for (const VertexImage& image : swapped.vertices) {
        touched.vertices.push_back(image.slot);
        if (image.slot >= m_mesh.slots().vertices || !m_mesh.isVertex(image.slot))
            continue;
        const bool wasHidden = image.live && (image.part & hiddenBit) != 0;
        m_mesh.forEachOutgoing(image.slot, [&](Slot h) {
            m_swappedFaces.add(m_mesh.face(h));
            if (m_mesh.isHidden(image.slot) != wasHidden)
                touched.faces.push_back(m_mesh.face(h)); // to be drawn, or no longer
        });
    }
    m_octree.removeDead(m_mesh, touched.faces);
    m_octree.update(m_mesh, m_swappedFaces.slots());
    if (swapped.frame.parts != m_mesh.frame().parts)
        addShownOrHidden(swapped.frame.parts, touched.faces);
    m_dirtySlots.add(m_mesh, touched, m_swappedFaces.slots());
}

/// Adds the faces of parts that were shown or hidden. Cost: O(mesh).
void VerifiedMesh::addShownOrHidden(const PartList& before, std::vector<Slot>& faces) const
{
    const PartList& now = m_mesh.frame().parts;
    for (const Slot f : m_mesh.faces()) {
        const PartId part = m_mesh.partOfFace(f);
        if (before.isVisible(part) != now.isVisible(part))
            faces.push_back(f);
    }
}
} // namespace core
