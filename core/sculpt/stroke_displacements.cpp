#include "core/sculpt/stroke_displacements.h"

#include "core/geometry/point_triangle.h"

namespace core
{
/// Drag tools follow the hand: they have no path over the surface.
bool StrokeDisplacements::areUsedBy(const StrokeSettings& settings)
{
    const bool isOnSurface = settings.brush == BrushShape::Ray || settings.place != Placement::Point;
    return settings.tool == Tool::Layer || (isOnSurface && settings.spacing > 0 && !isDragTool(settings.tool));
}

void StrokeDisplacements::clear()
{
    m_vertices.clear();
    m_displacements.clear();
}

void StrokeDisplacements::recall(Region& region, const Mesh& mesh) const
{
    region.forEach([&](Slot v) { region.setCarried(v, of(v).value_or(meanAround(v, mesh)).norm()); });
}

void StrokeDisplacements::note(const Region& region, const Mesh& mesh, double share, MirrorMap* mirror)
{
    std::vector<std::optional<Vec3>> sums;
    for (Slot v : region.slots()) {
        sums.emplace_back();
        if (region.contains(v))
            sums.back() = of(v).value_or(meanAround(v, mesh)) + share * region.plan(v);
    }
    for (std::size_t i = 0; i < sums.size(); ++i) {
        const Slot v = region.slots()[i];
        set(v, sums[i]);
        if (const Slot image = mirror && sums[i] ? mirror->imageOf(v) : noSlot; image != noSlot && image != v)
            set(image, mirror->imageOf(*sums[i]));
    }
}

void StrokeDisplacements::set(Slot v, const std::optional<Vec3>& displacement)
{
    const Slot i = m_vertices.add(v);
    m_displacements.resize(m_vertices.size());
    m_displacements[i] = displacement;
}

std::optional<Vec3> StrokeDisplacements::of(Slot v) const
{
    const Slot i = m_vertices.find(v);
    return i == noSlot ? std::nullopt : m_displacements[i];
}

Vec3 StrokeDisplacements::atRest(const SurfaceHit& hit, const Mesh& mesh) const
{
    const Triangle& corners = mesh.corners(hit.face);
    const auto point = [&](std::size_t i) { return Vec3(mesh.point(corners[i]).cast<double>()); };
    const std::array<double, 3> weights = cornerWeights(hit.position, {point(0), point(1), point(2)});
    Vec3 place = hit.position;
    for (std::size_t i = 0; i < 3; ++i)
        place -= weights[i] * of(corners[i]).value_or(Vec3::Zero());
    return place;
}

/// Returns the mean displacement of the neighbours whose displacement is known, or none.
Vec3 StrokeDisplacements::meanAround(Slot v, const Mesh& mesh) const
{
    Vec3 sum = Vec3::Zero();
    int known = 0;
    mesh.forEachOutgoing(v, [&](Slot h) {
        if (const std::optional<Vec3> beside = of(mesh.to(h))) {
            sum += *beside;
            ++known;
        }
    });
    return known > 0 ? Vec3(sum / known) : sum;
}
} // namespace core
