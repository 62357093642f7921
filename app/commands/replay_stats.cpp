#include "app/commands/replay_stats.h"

#include "app/platform/process_usage.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdio>
#include <numbers>
#include <numeric>

namespace app
{
namespace
{
using Json = nlohmann::ordered_json;

Json toJson(const ReplayedDab& dab)
{
    const core::DabReport& report = dab.report;
    const auto quality = [&](auto figure) { return dab.quality ? Json(figure(*dab.quality)) : Json(); };
    return {{"select_ms", report.selectMs},
            {"optimise_ms", report.optimiseMs},
            {"deform_ms", report.deformMs},
            {"fuse_ms", report.fuseMs},
            {"verify_ms", report.verifyMs},
            {"total_ms", report.totalMs},
            {"cpu_ms", dab.cpuMs},
            {"touched_vertices", report.touchedVertices},
            {"touched_faces", report.touchedFaces},
            {"substeps", report.substeps},
            {"asked", report.asked},
            {"reached", report.reached},
            {"contact", report.contact},
            {"wall", report.wall},
            {"capped", report.capped},
            {"longest_edge", quality([](const core::SelectionQuality& q) { return q.longestEdge; })},
            {"conforming_share", quality([](const core::SelectionQuality& q) { return q.conformingShare; })},
            {"smallest_angle_deg", quality([](const core::SelectionQuality& q) {
                 return std::asin(std::min(q.smallestAngleSine, 1.0)) * 180 / std::numbers::pi;
             })},
            {"outcome", std::string(core::name(report.outcome))}};
}

std::size_t countComponents(const core::TriangleMesh& mesh)
{
    std::vector<core::Slot> parent(mesh.points.size());
    std::iota(parent.begin(), parent.end(), core::Slot(0));
    const auto root = [&](core::Slot v) {
        while (parent[v] != v)
            v = parent[v] = parent[parent[v]];
        return v;
    };
    std::size_t count = mesh.points.size();
    const auto join = [&](core::Slot a, core::Slot b) {
        a = root(a);
        b = root(b);
        if (a == b)
            return;
        parent[std::max(a, b)] = std::min(a, b);
        --count;
    };
    for (const core::Triangle& triangle : mesh.triangles) {
        join(triangle[0], triangle[1]);
        join(triangle[1], triangle[2]);
    }
    return count;
}

Json totalsOf(const core::Sculptor& sculptor, const core::TriangleMesh& mesh)
{
    const core::SlotCounts live = sculptor.mesh().live();
    const core::SculptorTotals& totals = sculptor.totals();
    const auto euler = static_cast<std::int64_t>(live.vertices) - live.edges + live.faces;
    const auto components = static_cast<std::int64_t>(countComponents(mesh));
    char hash[17];
    std::snprintf(hash, sizeof hash, "%016llx", static_cast<unsigned long long>(sculptor.mesh().meshHash()));
    return {{"vertices", live.vertices},
            {"faces", live.faces},
            {"euler", euler},
            {"components", components},
            {"genus", components - euler / 2}, // for closed orientable surfaces; the sum over all components
            {"splits", totals.splits},
            {"collapses", totals.collapses},
            {"flips", totals.flips},
            {"fusions", totals.fusions},
            {"separations", totals.separations},
            {"rolled_back", totals.rolledBack},
            {"verify_tiers", totals.verifyTiers},
            {"peak_rss_mb", peakRssMb()},
            {"mesh_hash", hash}};
}
} // namespace

void writeReplayStats(core::AtomicFile& file, const std::vector<ReplayedDab>& dabs, const core::Sculptor& sculptor,
                      const core::TriangleMesh& mesh)
{
    file.write("{\"dabs\":[");
    for (std::size_t i = 0; i < dabs.size(); ++i)
        file.write((i == 0 ? "\n" : ",\n") + toJson(dabs[i]).dump());
    const std::string totals = totalsOf(sculptor, mesh).dump();
    file.write("],\n" + totals.substr(1) + "\n"); // dabs and totals are written as one object
}
} // namespace app
