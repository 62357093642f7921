#include "core/sculpt/select/selector.h"

#include "core/geometry/lattice_box.h"
#include "core/geometry/point_triangle.h"
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

void Selector::keepNearestPart(Region& region, const Sphere& ball) const
{
    const std::optional<SurfaceHit> nearest = nearestPoint(m_mesh, m_octree, ball.center, ball.radius);
    if (!nearest)
        return;
    const auto meetsBall = [&](Slot f) {
        const Triangle& t = m_mesh.corners(f);
        const auto point = [&](int i) { return Vec3(m_mesh.point(t[i]).cast<double>()); };
        return (nearestInTriangle(ball.center, {point(0), point(1), point(2)}) - ball.center).norm() <= ball.radius;
    };
    SlotSet& part = region.scratch(); // faces of the part, and faces outside the ball that border on it
    part.clear();
    part.add(nearest->face);
    for (std::size_t i = 0; i < part.slots().size(); ++i) { // the set grows during the loop
        const Slot f = part.slots()[i];
        if (!meetsBall(f))
            continue;
        Slot h = m_mesh.faceHalfedge(f);
        for (int side = 0; side < 3; ++side, h = m_mesh.next(h))
            part.add(m_mesh.face(h ^ 1));
    }
    region.forEach([&](Slot v) {
        bool isInPart = false;
        m_mesh.forEachOutgoing(v, [&](Slot h) { isInPart = isInPart || part.contains(m_mesh.face(h)); });
        if (!isInPart)
            region.remove(v);
    });
}

/// Sorts the faces, because the order in which the octree finds them depends on the octree's history.
std::vector<Slot> Selector::facesIn(const Sphere& ball) const
{
    std::vector<Slot> faces = core::facesIn(m_mesh, m_octree, latticeBox(m_mesh.lattice(), ball));
    std::ranges::sort(faces);
    return faces;
}
} // namespace core
