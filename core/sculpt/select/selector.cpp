#include "core/sculpt/select/selector.h"

#include "core/geometry/lattice_box.h"
#include "core/mesh/surface_query.h"

#include <algorithm>

namespace core
{
void Selector::select(Region& region, std::vector<Slot>& candidates, BrushShape brush, const Sphere& ball,
                      Slot max) const
{
    if (brush == BrushShape::Sphere) {
        selectSphere(region, candidates, m_mesh, m_octree, ball);
        return;
    }
    candidates.clear();
    region.clear();
    if (const std::optional<SurfaceHit> hit = nearestPoint(m_mesh, m_octree, ball.center)) {
        candidates.push_back(hit->face);
        selectGeodesic(region, candidates, m_mesh, ball, max);
    }
}

void Selector::selectRefined(Region& selected, Region& refined, std::vector<Slot> candidates, const Sphere& ball) const
{
    for (Slot v : refined.remeshed().slots())
        m_mesh.forEachOutgoing(v, [&](Slot h) { candidates.push_back(m_mesh.face(h)); });
    selectGeodesic(selected, candidates, m_mesh, ball);
}

/// Sorted: the order in which the octree finds faces depends on its history.
std::vector<Slot> Selector::facesIn(const Sphere& ball) const
{
    std::vector<Slot> faces = core::facesIn(m_mesh, m_octree, latticeBox(m_mesh.lattice(), ball));
    std::ranges::sort(faces);
    return faces;
}
} // namespace core
