#include "core/sculpt/deform/stroke_displacements.h"

#include "core/geometry/point_triangle.h"

namespace core
{
namespace
{
/// A doubtful displacement is replaced by its estimate if the two differ by more than this share of the length of the
/// neighbours' mean displacement.
constexpr double tolerance = 0.3;
} // namespace

/// Drag tools do not use displacements, because they follow the pointer and not a path over the surface.
bool StrokeDisplacements::areUsedBy(const StrokeSettings& settings)
{
    const bool isOnSurface = settings.brush == BrushShape::Ray || settings.place != Placement::Point;
    return settings.tool == Tool::Layer || (isOnSurface && settings.spacing > 0 && !isDragTool(settings.tool));
}

void StrokeDisplacements::clear()
{
    m_vertices.clear();
    m_displacements.clear();
    m_longest = 0;
    m_doubtful.clear();
}

void StrokeDisplacements::doubt(const SlotSet& remeshed)
{
    for (Slot v : remeshed.slots())
        m_doubtful.add(v);
}

void StrokeDisplacements::meet(const Region& region, MirrorMap* mirror)
{
    region.forEach([&](Slot v) {
        if (!of(v))
            set(v, Vec3(Vec3::Zero()), mirror);
    });
}

void StrokeDisplacements::fill(const Region& region, const Mesh& mesh, MirrorMap* mirror)
{
    // set only after this loop, so that every mean uses the old values, in whatever order vertices are visited
    std::vector<std::pair<Slot, Vec3>> all;
    region.forEach([&](Slot v) { all.emplace_back(v, believed(v, mesh)); });
    for (const auto& [v, displacement] : all)
        set(v, displacement, mirror);
}

void StrokeDisplacements::note(const Region& region, const Mesh& mesh, double share, MirrorMap* mirror)
{
    std::vector<std::optional<Vec3>> sums;
    for (Slot v : region.slots()) {
        sums.emplace_back();
        if (region.contains(v))
            sums.back() =
                of(v).value_or(meanAround(v, mesh)) + mesh.lattice().snap(share * region.plan(v)).cast<double>();
    }
    for (std::size_t i = 0; i < sums.size(); ++i)
        set(region.slots()[i], sums[i], mirror);
}

/// Sets the displacement of a vertex, and of its image if there is a mirror.
void StrokeDisplacements::set(Slot v, const std::optional<Vec3>& displacement, MirrorMap* mirror)
{
    set(v, displacement);
    if (const Slot image = mirror && displacement ? mirror->imageOf(v) : noSlot; image != noSlot && image != v)
        set(image, mirror->imageOf(*displacement));
}

void StrokeDisplacements::set(Slot v, const std::optional<Vec3>& displacement)
{
    const Slot i = m_vertices.add(v);
    m_displacements.resize(m_vertices.size());
    m_displacements[i] = displacement;
    if (displacement)
        m_longest = std::max(m_longest, displacement->norm());
}

std::optional<Vec3> StrokeDisplacements::of(Slot v) const
{
    const Slot i = m_vertices.find(v);
    return i == noSlot ? std::nullopt : m_displacements[i];
}

/// Sums cross products of lattice vectors. The sum is exact, so it does not depend on the edge where it starts.
Vec3 StrokeDisplacements::normalAtRest(Slot v, const Mesh& mesh) const
{
    const Vec3 p = restPoint(v, mesh);
    Vec3 sum = Vec3::Zero();
    mesh.forEachOutgoing(v, [&](Slot h) {
        const Vec3 spoke = restPoint(mesh.to(h), mesh) - p, next = restPoint(mesh.to(mesh.rotate(h)), mesh) - p;
        sum += spoke.cross(next);
    });
    const double length = sum.norm();
    return length > 0 ? Vec3(sum / length) : Vec3::Zero();
}

Vec3 StrokeDisplacements::restPoint(Slot v, const Mesh& mesh) const
{
    return mesh.point(v).cast<double>() - of(v).value_or(Vec3::Zero());
}

std::array<Vec3, 3> StrokeDisplacements::cornersAtRest(Slot f, const Mesh& mesh) const
{
    const Triangle& t = mesh.corners(f);
    return {restPoint(t[0], mesh), restPoint(t[1], mesh), restPoint(t[2], mesh)};
}

Vec3 StrokeDisplacements::atRest(const SurfaceHit& hit, const Mesh& mesh) const
{
    const Triangle& t = mesh.corners(hit.face);
    const auto point = [&](Slot v) { return Vec3(mesh.point(v).cast<double>()); };
    return hit.position - displacementIn(t, cornerWeights(hit.position, {point(t[0]), point(t[1]), point(t[2])}));
}

Vec3 StrokeDisplacements::now(const SurfaceHit& atRest, const Mesh& mesh) const
{
    const std::array<double, 3> weights = cornerWeights(atRest.position, cornersAtRest(atRest.face, mesh));
    return atRest.position + displacementIn(mesh.corners(atRest.face), weights);
}

Vec3 StrokeDisplacements::displacementIn(const Triangle& corners, const std::array<double, 3>& weights) const
{
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = 0; i < 3; ++i)
        sum += weights[i] * of(corners[i]).value_or(Vec3::Zero());
    return sum;
}

/// Returns the mean of the neighbours' known displacements, rounded to the lattice; zero if none is known.
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
    return known > 0 ? Vec3(mesh.lattice().snap(sum / known).cast<double>()) : sum;
}

/// Returns the tracked displacement of v, or the neighbours' mean if none is tracked. A doubtful value that differs
/// much from the estimate is replaced by the estimate.
Vec3 StrokeDisplacements::believed(Slot v, const Mesh& mesh) const
{
    const std::optional<Vec3> tracked = of(v);
    if (!tracked)
        return meanAround(v, mesh);
    if (!m_doubtful.contains(v))
        return *tracked;
    const Vec3 mean = meanAround(v, mesh), estimated = estimate(v, mesh);
    return (estimated - *tracked).norm() > tolerance * mean.norm() ? estimated : *tracked;
}

/// Returns an estimate of v's displacement: its offset from the mean of its neighbours' positions before the stroke,
/// projected onto the mean of their displacements.
Vec3 StrokeDisplacements::estimate(Slot v, const Mesh& mesh) const
{
    const Vec3 mean = meanAround(v, mesh);
    if (mean.isZero(0))
        return mean;
    Vec3 rest = Vec3::Zero();
    int count = 0;
    mesh.forEachOutgoing(v, [&](Slot h) {
        rest += restPoint(mesh.to(h), mesh);
        ++count;
    });
    const Vec3 above = mesh.point(v).cast<double>() - rest / count;
    return mesh.lattice().snap(above.dot(mean) / mean.squaredNorm() * mean).cast<double>();
}
} // namespace core
