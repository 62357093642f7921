// Reproduces the paper's Table 1: the mean of each phase over 20 operations of one tool with one brush, on a sphere of
// 2562 vertices.
// The paper does not state its radius. At 0.25 of the sphere's radius each operation splits and collapses edges.
#include "tests/bench/bench_models.h"
#include "tests/bench/bench_stroke.h"

#include <cmath>

namespace
{
using core::DabReport;
using core::Tool;

constexpr int operations = 20;
constexpr double radius = 0.25;

/// A row of the paper's table, in milliseconds on an Intel i7-11700F.
struct PaperRow
{
    core::BrushShape brush;
    Tool tool;
    double select, optimise, deform, total;
};
constexpr PaperRow paperRows[] = {
    {core::BrushShape::Sphere, Tool::Pull, 0.092, 0.133, 0.0019, 3.944},
    {core::BrushShape::Sphere, Tool::Push, 0.071, 0.101, 0.0019, 3.993},
    {core::BrushShape::Sphere, Tool::Flatten, 0.068, 0.022, 0.0028, 3.643},
    {core::BrushShape::Sphere, Tool::Smooth, 0.075, 0.028, 0.0054, 3.782},
    {core::BrushShape::Ray, Tool::Pull, 0.796, 0.085, 0.0017, 4.737},
    {core::BrushShape::Ray, Tool::Push, 0.869, 0.086, 0.0016, 4.692},
    {core::BrushShape::Ray, Tool::Flatten, 1.009, 0.029, 0.0028, 4.897},
    {core::BrushShape::Ray, Tool::Smooth, 0.897, 0.041, 0.0062, 4.732},
};

core::StrokeSample sampleAt(core::BrushShape brush, double angle)
{
    const core::Vec3 outward(std::cos(angle), 0, std::sin(angle));
    core::StrokeSample sample;
    sample.position = brush == core::BrushShape::Ray ? core::Vec3(3 * outward) : outward;
    sample.direction = -outward;
    return sample;
}

void table1(benchmark::State& state)
{
    const PaperRow& paper = paperRows[state.range(0)];
    state.SetLabel(std::string(name(paper.brush)) + ", " + std::string(name(paper.tool)));
    for ([[maybe_unused]] auto round : state) {
        core::Sculptor sculptor(bench::opened(bench::geodesicSphere(16)));
        core::StrokeSettings settings;
        settings.tool = paper.tool;
        settings.brush = paper.brush;
        settings.radius = radius;
        DabReport sum;
        double patch = 0, cpu = 0;
        sculptor.beginStroke(settings);
        for (int i = 0; i < operations; ++i) {
            const bench::Clocks start = bench::Clocks::now();
            const DabReport report = sculptor.addSample(sampleAt(paper.brush, 0.3 * i)).front();
            const bench::Clocks dab = bench::Clocks::now();
            benchmark::DoNotOptimize(sculptor.takePatch());
            const bench::Clocks end = bench::Clocks::now();
            patch += 1e-3 * end.since(dab).wall;
            cpu += 1e-3 * end.since(start).thread;
            sum.selectMs += report.selectMs;
            sum.optimiseMs += report.optimiseMs;
            sum.deformMs += report.deformMs;
            sum.fuseMs += report.fuseMs;
            sum.verifyMs += report.verifyMs;
            sum.totalMs += report.totalMs;
            sum.touchedVertices += report.touchedVertices;
        }
        sculptor.endStroke();
        state.SetIterationTime(1e-3 * (sum.totalMs + patch) / operations);
        state.counters["select"] = sum.selectMs / operations;
        state.counters["optimise"] = sum.optimiseMs / operations;
        state.counters["deform"] = sum.deformMs / operations;
        state.counters["fuse"] = sum.fuseMs / operations;
        state.counters["verify"] = sum.verifyMs / operations;
        state.counters["patch"] = patch / operations;
        state.counters["total"] = (sum.totalMs + patch) / operations;
        state.counters["cpu"] = cpu / operations;
        state.counters["touched"] = static_cast<double>(sum.touchedVertices) / operations;
        state.counters["paper_select"] = paper.select;
        state.counters["paper_optimise"] = paper.optimise;
        state.counters["paper_deform"] = paper.deform;
        state.counters["paper_total"] = paper.total;
    }
}
BENCHMARK(table1)->DenseRange(0, 7)->Iterations(1)->UseManualTime()->Unit(benchmark::kMicrosecond);
} // namespace
