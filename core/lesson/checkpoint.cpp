#include "core/lesson/checkpoint.h"

#include "core/analysis/mesh_check.h"
#include "core/analysis/surface_distance.h"
#include "core/geometry/face_geometry.h"
#include "core/lesson/model_facts.h"

#include <algorithm>
#include <cassert>
#include <numeric>

namespace core
{
namespace
{
std::optional<double> measured(Fact fact, const TriangleMesh& model, const MeshReport& report)
{
    switch (fact) {
    case Fact::Genus:
        return report.genus ? std::optional(static_cast<double>(*report.genus)) : std::nullopt;
    case Fact::Components:
        return static_cast<double>(report.components);
    case Fact::Height:
        return report.size.y();
    case Fact::Width:
        return report.size.x();
    case Fact::Depth:
        return report.size.z();
    case Fact::Widest:
        return widestOf(model);
    case Fact::Feet:
        return static_cast<double>(feetOf(model));
    case Fact::BaseArea:
        return baseAreaOf(model, report);
    case Fact::Grooves:
        return static_cast<double>(groovesOf(model));
    case Fact::Volume:
        return report.volume;
    case Fact::Faces:
        return static_cast<double>(report.faces);
    case Fact::PrintReady:
        return report.printReady() ? 1 : 0;
    }
    return std::nullopt;
}

/// Returns for each point a third of the area of its faces.
std::vector<double> areasAround(const TriangleMesh& mesh)
{
    std::vector<double> areas(mesh.points.size(), 0);
    for (Slot f = 0; f < mesh.triangles.size(); ++f) {
        const auto [a, b, c] = cornersOf(mesh, f);
        const double third = (b - a).cross(c - a).norm() / 6;
        for (const Slot v : mesh.triangles[f])
            areas[v] += third;
    }
    return areas;
}

/// Returns the distance within which `share` of the surface's area is. Each corner represents the area around it.
double within(double share, const TriangleMesh& mesh, const std::vector<float>& distances)
{
    const std::vector<double> areas = areasAround(mesh);
    std::vector<Slot> order(distances.size());
    std::iota(order.begin(), order.end(), Slot(0));
    std::ranges::sort(order, {}, [&](Slot v) { return std::pair(distances[v], v); });
    double left = share * std::accumulate(areas.begin(), areas.end(), 0.0);
    for (const Slot v : order) {
        left -= areas[v];
        if (left <= 0)
            return distances[v];
    }
    return distances[order.back()];
}

TargetVerdict evaluate(const CheckpointTarget& asked, const TriangleMesh& model, const TriangleMesh& target,
                       const JobControl& control)
{
    TargetVerdict verdict;
    verdict.tolerance = asked.tolerance;
    verdict.distances = distancesTo(target, model.points, control.part(0, 0.5));
    const std::vector<float> back = distancesTo(model, target.points, control.part(0.5, 1));
    verdict.nearDistance = std::max(within(CheckpointTarget::nearShare, model, verdict.distances),
                                    within(CheckpointTarget::nearShare, target, back));
    verdict.largest = std::max(std::ranges::max(verdict.distances), std::ranges::max(back));
    verdict.holds = verdict.nearDistance <= asked.tolerance;
    return verdict;
}
} // namespace

bool CheckpointVerdict::isMet() const
{
    return std::ranges::all_of(facts, &FactVerdict::holds) && (!target || target->holds);
}

CheckpointVerdict evaluate(const Checkpoint& checkpoint, const TriangleMesh& model, const TriangleMesh* target,
                           const JobControl& control)
{
    assert(!checkpoint.target || (target && !target->triangles.empty() && !model.triangles.empty()));
    const double afterFacts = checkpoint.facts.empty() ? 0 : checkpoint.target ? 0.5 : 1;
    CheckpointVerdict verdict;
    if (!checkpoint.facts.empty()) {
        const MeshReport report = checkMesh(model, control.part(0, afterFacts));
        for (const FactBounds& asked : checkpoint.facts) {
            const std::optional<double> value = measured(asked.fact, model, report);
            verdict.facts.push_back({asked, value, value && *value >= asked.min && *value <= asked.max});
        }
    }
    if (checkpoint.target)
        verdict.target = evaluate(*checkpoint.target, model, *target, control.part(afterFacts, 1));
    return verdict;
}
} // namespace core
