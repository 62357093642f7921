#include "core/sculpt/fuse/fusion_surgery.h"

#include "core/sculpt/fuse/mirrored_join.h"

#include <algorithm>

namespace core
{
void FusionSurgery::beginDab(MirrorMap* mirror)
{
    m_mirror = mirror;
    m_failed.clear();
    m_failures.clear();
}

std::optional<Surgery> FusionSurgery::withItsImage(const VerifiedMesh& surface,
                                                   const std::optional<Surgery>& half) const
{
    if (!half || !m_mirror)
        return half;
    if (!m_mirror->learn(half->removed, surface.octree()))
        return std::nullopt;
    return withImage(surface.mesh(), *m_mirror, *half);
}

std::optional<std::vector<Slot>> FusionSurgery::operate(VerifiedMesh& surface, Region& region, const Surgery& surgery)
{
    Mesh& mesh = surface.mesh();
    const std::vector<Slot> before = cornersOf(mesh, surgery.removed);
    const bool isMasked = std::ranges::any_of(before, [&](Slot v) { return mesh.isMasked(v); });
    std::vector<Slot> created;
    if (isMasked || !surface.tryOperation([&] { created = mesh.replaceFaces(surgery); }))
        return std::nullopt;
    for (std::size_t i = 0; i < created.size(); ++i) {
        const Slot original = surgery.vertices[i].original;
        if (region.contains(original) && (!m_mirror || m_mirror->isInHalf(created[i])))
            region.add(created[i], region.distance(original), region.plan(original), region.carried(original));
    }
    if (m_mirror)
        pairUp(mesh, created);
    for (Slot v : before) {
        if (!mesh.isVertex(v) && region.contains(v))
            region.remove(v);
    }
    return created;
}

/// Registers in the mirror map which of the created vertices are each other's images.
void FusionSurgery::pairUp(const Mesh& mesh, const std::vector<Slot>& created)
{
    for (Slot v : created) {
        for (Slot w : created) {
            if (mesh.point(w) == m_mirror->imageOf(mesh.point(v)))
                m_mirror->pair(v, w);
        }
    }
}

void FusionSurgery::countFailure(Slot v)
{
    const Slot i = m_failed.add(v);
    m_failures.resize(m_failed.size());
    ++m_failures[i];
}
} // namespace core
