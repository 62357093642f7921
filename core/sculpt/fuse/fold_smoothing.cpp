#include "core/sculpt/fuse/fold_smoothing.h"

#include "core/mesh/normals.h"

#include <algorithm>

namespace core
{
namespace
{
constexpr double smoothing = 0.5;

/// Returns `step` without its component against the direction of `way`.
Vec3 withoutReturn(const Vec3& step, const Vec3& way)
{
    const double along = step.dot(way);
    return along < 0 ? Vec3(step - along / way.squaredNorm() * way) : step;
}
} // namespace

void FoldSmoothing::clear()
{
    m_vertices.clear();
    m_takenBack.clear();
}

bool FoldSmoothing::smooth(VerifiedMesh& surface, MeshEditor edit, Region& region, std::span<const Slot> vertices,
                           bool mayTakeBack)
{
    const Mesh& mesh = surface.mesh();
    std::vector<std::pair<Slot, Vec3f>> places;
    for (Slot v : withNeighbours(region, mesh, vertices)) {
        const Vec3 p = mesh.point(v).cast<double>();
        Vec3 step = neighbourMean(mesh, v) - p;
        if (!mayTakeBack)
            step = withoutReturn(step, region.plan(v));
        const Vec3f place = edit.kept(v, mesh.lattice().snap(p + smoothing * mesh.freedom(v) * step));
        if (place != mesh.point(v))
            places.emplace_back(v, place);
    }
    std::vector<Vec3> steps;
    for (const auto& [v, place] : places)
        steps.push_back((place - mesh.point(v)).cast<double>());
    const bool sound = !places.empty() && surface.tryOperation([&] {
        for (const auto& [v, place] : places)
            edit.move(v, place);
    });
    for (std::size_t i = 0; sound && i < places.size(); ++i) {
        const Vec3& plan = region.plan(places[i].first);
        const double length = plan.norm();
        const Slot position = m_vertices.add(places[i].first);
        m_takenBack.resize(m_vertices.size(), 0.0);
        m_takenBack[position] -= length > 0 ? steps[i].dot(plan) / length : 0;
    }
    return sound;
}

double FoldSmoothing::shareLeft(const Region& region, double done) const
{
    if (m_vertices.size() == 0)
        return done;
    double planned = 0, left = 0;
    region.forEach([&](Slot v) {
        const double plan = region.plan(v).norm();
        const Slot i = m_vertices.find(v);
        planned = std::max(planned, plan);
        left = std::max(left, done * plan - (i == noSlot ? 0 : std::max(0.0, m_takenBack[i])));
    });
    return planned > 0 ? left / planned : done;
}
} // namespace core
