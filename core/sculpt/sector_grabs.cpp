#include "core/sculpt/sector_grabs.h"

#include "core/mesh/surface_query.h"

#include <utility>

namespace core
{
void SectorGrabs::beginStroke()
{
    m_sectors.resize(1);
    first().own.release();
    first().image.release();
    first().image.region.clear();
}

GrabPair& SectorGrabs::in(std::size_t sector, Tool tool)
{
    if (!keepsSelection(tool))
        return first();
    m_sectors[sector].grabs.dropRemoved(m_surface.mesh());
    return m_sectors[sector].grabs;
}

void SectorGrabs::dropRemoved()
{
    for (Sector& sector : m_sectors)
        sector.grabs.dropRemoved(m_surface.mesh());
}

GrabSnapshot SectorGrabs::snapshot(const GrabPair& grabs, const Dab& dab, Symmetry symmetry) const
{
    const Mesh& mesh = m_surface.mesh();
    const Region& region = grabs.own.region;
    GrabSnapshot snapshot = {grabs.own.state, grabs.image.state, {}, {}, dab};
    if (!grabs.own.state.isHalf) {
        const auto copy = [&](const Region& from, std::vector<GrabSnapshot::Point>& to) {
            from.forEach([&](Slot v) { to.push_back({mesh.point(v), from.distance(v)}); });
        };
        copy(region, snapshot.ownPoints);
        copy(grabs.image.region, snapshot.imagePoints);
        return snapshot;
    }
    MirrorMap mirror(mesh);
    mirror.setPlane(symmetry);
    const bool isOver = mirror.folded(dab.position) != dab.position; // the dab is on the mirror's negative side
    region.forEach([&](Slot v) {
        const Vec3f point = mesh.point(v), image = mirror.imageOf(point);
        snapshot.ownPoints.push_back({isOver ? image : point, region.distance(v)});
        if (!mirror.isOnPlane(v) && region.carried(v) <= dab.radius)
            snapshot.ownPoints.push_back({isOver ? point : image, region.carried(v)});
    });
    if (isOver) {
        snapshot.own.axis = mirror.imageOf(snapshot.own.axis);
        snapshot.own.moved = mirror.imageOf(snapshot.own.moved);
    }
    return snapshot;
}

/// Turns the image's points by the inverse turn: in the mirror, the rotation from sector to sector is reversed.
void SectorGrabs::separate(std::size_t sector, const GrabSnapshot& snapshot, const Turn& turn, Symmetry symmetry)
{
    GrabPair& grabs = m_sectors[sector].grabs;
    if (std::exchange(m_sectors[sector].isSeparate, true) || !snapshot.own.isOn)
        return;
    if (snapshot.own.isHalf)
        return grabHalf(grabs, snapshot, turn, symmetry);
    const Turn back = {turn.cosine, -turn.sine};
    const std::size_t known = m_surface.mesh().removedVertices().size();
    grabs.own.state = {true, false, turn * snapshot.own.axis, turn * snapshot.own.moved, snapshot.own.detail, known};
    grabs.image.state = {snapshot.image.isOn,   false, back * snapshot.image.axis, back * snapshot.image.moved,
                         snapshot.image.detail, known};
    grabPoints(grabs.own.region, snapshot.ownPoints, turn);
    grabPoints(grabs.image.region, snapshot.imagePoints, back);
}

/// Rebuilds a half grab (GrabState::isHalf) in another sector. The mirror plane does not turn with the sector, so
/// another half of the whole grab is stored there.
void SectorGrabs::grabHalf(GrabPair& grabs, const GrabSnapshot& snapshot, const Turn& turn, Symmetry symmetry) const
{
    const Mesh& mesh = m_surface.mesh();
    MirrorMap mirror(mesh);
    mirror.setPlane(symmetry);
    const Vec3 position = turn * snapshot.dab.position;
    const bool isOver = mirror.folded(position) != position; // the dab is on the mirror's negative side
    const auto turned = [&](const Vec3& p) { return isOver ? mirror.imageOf(Vec3(turn * p)) : Vec3(turn * p); };
    grabs.own.state = {true,
                       true,
                       turned(snapshot.own.axis),
                       turned(snapshot.own.moved),
                       snapshot.own.detail,
                       mesh.removedVertices().size()};
    grabs.image.release();
    grabs.image.region.clear();
    Region& region = grabs.own.region;
    const auto placeOf = [&](const GrabSnapshot::Point& point) {
        return isOver ? mirror.imageOf(turn * point.place) : turn * point.place;
    };
    const auto at = [&](const Vec3f& p) { return vertexAt(mesh, m_surface.octree(), p); };
    region.clear();
    for (const GrabSnapshot::Point& point : snapshot.ownPoints) {
        if (const Slot v = at(placeOf(point)); v != noSlot && mirror.isInHalf(v))
            region.add(v, point.distance, Vec3::Zero(), 2 * snapshot.dab.radius);
    }
    for (const GrabSnapshot::Point& point : snapshot.ownPoints) {
        if (const Slot v = at(mirror.imageOf(placeOf(point))); v != noSlot && region.contains(v))
            region.setCarried(v, point.distance);
    }
}

void SectorGrabs::grabPoints(Region& region, const std::vector<GrabSnapshot::Point>& points, const Turn& turn) const
{
    region.clear();
    for (const GrabSnapshot::Point& point : points) {
        if (const Slot v = vertexAt(m_surface.mesh(), m_surface.octree(), turn * point.place); v != noSlot)
            region.add(v, point.distance);
    }
}
} // namespace core
