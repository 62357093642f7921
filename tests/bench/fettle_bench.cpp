// What a dab costs: the strokes that peers were measured on, the paper's Table 1, and memory. By hand:
//   fettle_bench [--benchmark_filter=peers] [--benchmark_repetitions=5 --benchmark_enable_random_interleaving=true]
// Times are in microseconds; "cpu" is the thread's own, "wall" stands beside it.

#include "core/morton_order.h"
#include "core/sculptor.h"
#include "tests/support/mesh_asserts.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <map>
#include <unistd.h>

namespace
{
using core::DabReport;
using core::Sculptor;
using core::Slot;
using core::Tool;
using core::TriangleMesh;
using core::Vec3;

/// An icosahedron whose edges are cut into n: 10 n^2 + 2 vertices on the sphere of radius 1.
TriangleMesh geodesicSphere(Slot n)
{
    const TriangleMesh base = core::icosphere(0, 1);
    TriangleMesh mesh;
    std::map<std::array<Slot, 6>, Slot> known; // of vertices on an edge or a corner: (corner, weight) thrice, 0 where none
    const auto vertex = [&](const core::Triangle& t, std::array<Slot, 3> weights) {
        Vec3 p = Vec3::Zero();
        std::array<std::pair<Slot, Slot>, 3> parts{};
        std::size_t used = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            p += static_cast<double>(weights[i]) * base.points[t[i]].cast<double>();
            if (weights[i] > 0)
                parts[used++] = {t[i] + 1, weights[i]};
        }
        const auto add = [&] {
            mesh.points.push_back(p.normalized().cast<float>());
            return static_cast<Slot>(mesh.points.size() - 1);
        };
        if (used == 3)
            return add();
        std::ranges::sort(parts);
        const std::array<Slot, 6> key = {parts[0].first, parts[0].second, parts[1].first,
                                         parts[1].second, parts[2].first, parts[2].second};
        const auto found = known.find(key);
        return found != known.end() ? found->second : known.emplace(key, add()).first->second;
    };
    for (const core::Triangle& t : base.triangles) {
        std::vector<std::vector<Slot>> rows(n + 1);
        for (Slot i = 0; i <= n; ++i) {
            for (Slot j = 0; j <= i; ++j)
                rows[i].push_back(vertex(t, {n - i, i - j, j}));
        }
        for (Slot i = 0; i < n; ++i) {
            for (Slot j = 0; j <= i; ++j) {
                mesh.triangles.push_back({rows[i][j], rows[i + 1][j], rows[i + 1][j + 1]});
                if (j < i)
                    mesh.triangles.push_back({rows[i][j], rows[i + 1][j + 1], rows[i][j + 1]});
            }
        }
    }
    return mesh;
}

std::unique_ptr<core::Mesh> opened(const TriangleMesh& mesh)
{
    const core::Lattice lattice = core::Lattice::forExtent(1);
    return mesh_asserts::sculptable(core::inMortonOrder(mesh, lattice), lattice);
}

const TriangleMesh& sphere(Slot n)
{
    static std::map<Slot, TriangleMesh> spheres;
    const auto known = spheres.find(n);
    return known != spheres.end() ? known->second : spheres.emplace(n, geodesicSphere(n)).first->second;
}

double cpuMicroseconds()
{
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return 1e6 * static_cast<double>(time.tv_sec) + 1e-3 * static_cast<double>(time.tv_nsec);
}

double wallMicroseconds()
{
    return std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

double percentile(std::vector<double> values, double part)
{
    std::ranges::sort(values);
    return values[std::min(values.size() - 1, static_cast<std::size_t>(part * static_cast<double>(values.size())))];
}

/// 200 pull dabs of 0.02 r on a great circle, 0.126 r apart. Arguments: edges of the icosahedron cut into, radius in 1e-6.
void peersStroke(benchmark::State& state)
{
    constexpr int dabs = 200;
    const double radius = 1e-6 * static_cast<double>(state.range(1));
    for ([[maybe_unused]] auto round : state) {
        Sculptor sculptor(opened(sphere(static_cast<Slot>(state.range(0)))));
        core::StrokeSettings settings;
        settings.radius = radius;
        settings.strength = 0.2;
        sculptor.beginStroke(settings);
        std::vector<double> cpu, wall, verify, patch, touched, perVertex;
        int whole = 0;
        for (int i = 0; i < dabs; ++i) {
            const double angle = 0.126 * radius * i;
            core::StrokeSample sample;
            sample.position = {std::cos(angle), 0, std::sin(angle)};
            const double cpuStart = cpuMicroseconds(), wallStart = wallMicroseconds();
            const DabReport report = sculptor.addSample(sample).front();
            const double cpuDab = cpuMicroseconds();
            benchmark::DoNotOptimize(sculptor.takePatch());
            const double cpuEnd = cpuMicroseconds();
            wall.push_back(wallMicroseconds() - wallStart);
            cpu.push_back(cpuEnd - cpuStart);
            patch.push_back(cpuEnd - cpuDab);
            verify.push_back(1000 * report.verifyMs);
            touched.push_back(report.touchedVertices);
            perVertex.push_back(cpu.back() / std::max(1u, report.touchedVertices));
            whole += report.outcome == core::DabOutcome::Committed && report.reached >= 0.999 * report.asked;
        }
        sculptor.endStroke();
        state.SetIterationTime(1e-6 * percentile(wall, 0.5));
        state.counters["cpu"] = percentile(cpu, 0.5);
        state.counters["cpu_p99"] = percentile(cpu, 0.99);
        state.counters["cpu_first"] = cpu.front();
        state.counters["wall"] = percentile(wall, 0.5);
        state.counters["wall_p99"] = percentile(wall, 0.99);
        state.counters["verify"] = percentile(verify, 0.5);
        state.counters["patch"] = percentile(patch, 0.5);
        state.counters["touched"] = percentile(touched, 0.5);
        state.counters["per_vertex"] = percentile(perVertex, 0.5);
        state.counters["whole_of_200"] = whole;
        state.counters["vertices"] = sculptor.mesh().live().vertices;
    }
}
BENCHMARK(peersStroke)
    ->ArgNames({"cuts", "radius_e-6"})
    ->Args({16, 250'000})  // 2,562 vertices
    ->Args({64, 62'500})   // 40,962
    ->Args({128, 31'000})  // 163,842
    ->Args({256, 15'600})  // 655,362
    ->Args({317, 12'600})  // 1,004,892
    ->Iterations(1)
    ->UseManualTime()
    ->Unit(benchmark::kMicrosecond);

/// The paper's Table 1: 20 operations of one tool on the sphere of 2562 vertices, the mean of each phase.
void table1(benchmark::State& state)
{
    constexpr int operations = 20;
    const Tool tool = static_cast<Tool>(state.range(0));
    state.SetLabel(std::string(name(tool)) + ", spherical brush");
    for ([[maybe_unused]] auto round : state) {
        Sculptor sculptor(opened(sphere(16)));
        core::StrokeSettings settings;
        settings.tool = tool;
        settings.radius = 0.25;
        sculptor.beginStroke(settings);
        DabReport sum;
        double touched = 0;
        for (int i = 0; i < operations; ++i) {
            core::StrokeSample sample;
            sample.position = Vec3(std::cos(0.3 * i), 0, std::sin(0.3 * i));
            const DabReport report = sculptor.addSample(sample).front();
            sum.selectMs += report.selectMs, sum.optimiseMs += report.optimiseMs, sum.deformMs += report.deformMs;
            sum.verifyMs += report.verifyMs, sum.totalMs += report.totalMs;
            touched += report.touchedVertices;
        }
        sculptor.endStroke();
        const auto mean = [](double milliseconds) { return 1000 * milliseconds / operations; };
        state.SetIterationTime(1e-3 * sum.totalMs / operations);
        state.counters["1_select"] = mean(sum.selectMs);
        state.counters["2_optimise"] = mean(sum.optimiseMs);
        state.counters["3_deform"] = mean(sum.deformMs);
        state.counters["4_verify"] = mean(sum.verifyMs);
        state.counters["5_total"] = mean(sum.totalMs);
        state.counters["touched"] = touched / operations;
    }
}
BENCHMARK(table1)
    ->ArgName("tool")
    ->Arg(static_cast<int>(Tool::Pull))
    ->Arg(static_cast<int>(Tool::Push))
    ->Arg(static_cast<int>(Tool::Smooth))
    ->Iterations(1)
    ->UseManualTime()
    ->Unit(benchmark::kMicrosecond);

/// Resident bytes of this process, 0 where that is not told.
double residentBytes()
{
    double pages = 0, resident = 0;
    std::ifstream statm("/proc/self/statm");
    statm >> pages >> resident;
    return resident * static_cast<double>(sysconf(_SC_PAGESIZE));
}

/// Mesh, octree, stamps: by how much the process grows.
void memory(benchmark::State& state)
{
    const TriangleMesh& source = sphere(317);
    for ([[maybe_unused]] auto round : state) {
        const double before = residentBytes();
        Sculptor sculptor(opened(source));
        state.SetIterationTime(1);
        const double vertices = sculptor.mesh().live().vertices;
        state.counters["vertices"] = vertices;
        state.counters["bytes_per_vertex"] = (residentBytes() - before) / vertices;
    }
}
BENCHMARK(memory)->Iterations(1)->UseManualTime();
} // namespace

BENCHMARK_MAIN();
