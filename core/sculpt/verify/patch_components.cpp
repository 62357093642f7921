#include "core/sculpt/verify/patch_components.h"

#include <algorithm>

namespace core
{
BoundaryEdge boundaryEdge(const Mesh& mesh, Slot h)
{
    const Slot from = mesh.from(h), to = mesh.to(h);
    return {from, to, mesh.latticePoint(from), mesh.latticePoint(to)};
}

void PatchComponents::find(const Mesh& mesh, const DirtyNeighbourhood& neighbourhood)
{
    m_component.assign(neighbourhood.size(), noSlot);
    m_components.clear();
    m_dirtyComponents = 0;
    for (Slot seed = 0; seed < neighbourhood.size(); ++seed) {
        if (m_component[seed] == noSlot)
            add(mesh, neighbourhood, seed);
        if (seed < neighbourhood.dirtyCount())
            m_dirtyComponents = static_cast<Slot>(m_components.size());
    }
}

/// Adds the patch that contains the face `seed`, which is in no patch yet. Dirty faces have the lowest indices and are
/// used as seeds first, so a patch with a clean seed contains no dirty face.
void PatchComponents::add(const Mesh& mesh, const DirtyNeighbourhood& neighbourhood, Slot seed)
{
    const Slot dirtyCount = neighbourhood.dirtyCount(), number = static_cast<Slot>(m_components.size());
    const bool isDirty = seed < dirtyCount;
    Component& component = m_components.emplace_back();
    Vec3 sum = Vec3::Zero(); // sum of the dirty faces' normals
    m_patch.clear();
    m_boundary.clear();
    m_component[seed] = number;
    m_front.assign(1, seed);
    while (!m_front.empty()) {
        const Slot at = m_front.back();
        m_front.pop_back();
        if (at < dirtyCount)
            sum += neighbourhood.normal(at);
        if (isDirty)
            m_patch.push_back(neighbourhood.shape(at));
        Slot h = mesh.faceHalfedge(neighbourhood.faces()[at]);
        for (int k = 0; k < 3; ++k, h = mesh.next(h)) {
            const Slot next = neighbourhood.indexOf(mesh.face(h ^ 1));
            if (next == noSlot) {
                component.isClosed = false;
                if (isDirty)
                    m_boundary.push_back(boundaryEdge(mesh, h));
            } else if (m_component[next] == noSlot) {
                m_component[next] = number;
                m_front.push_back(next);
            }
        }
    }
    component.isCertified = isDirty && !component.isClosed && certifyPatch(m_patch, m_boundary, integerDirection(sum));
}

bool PatchComponents::areCertified() const
{
    return m_dirtyComponents > 0 &&
           std::ranges::all_of(std::span(m_components).first(m_dirtyComponents), &Component::isCertified);
}
} // namespace core
