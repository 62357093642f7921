// Measures the print check of a model of a million vertices.
#include "tests/bench/bench_models.h"

#include "core/print/print_check.h"
#include "tests/support/shapes.h"

#include <benchmark/benchmark.h>

#include <chrono>

namespace
{
enum Part { Ball, Shell, Ring, Judging, Picture };

core::TriangleMesh scaled(core::TriangleMesh mesh, float by)
{
    for (core::Vec3f& p : mesh.points)
        p *= by;
    return mesh;
}

/// Makes a model 100 mm wide: a ball, a shell 1 mm thick, or a ring 8 mm thick. In the ring, each ball that measures
/// the wall almost touches many faces.
core::TriangleMesh model(Part part)
{
    if (part == Ring)
        return shapes::torus({46, 4, 2800, 358});
    if (part != Shell)
        return scaled(bench::geodesicSphere(317), 50);
    const core::TriangleMesh outer = scaled(bench::geodesicSphere(224), 50);
    return shapes::together(outer, shapes::reversed(scaled(outer, 0.98F)));
}

void print(benchmark::State& state)
{
    const char* const labels[] = {"walls of a ball", "of a shell", "of a ring", "judging by limits",
                                  "picture of overhangs"};
    const auto part = static_cast<Part>(state.range(0));
    state.SetLabel(labels[part]);
    core::PrintMeasures measures;
    measures.mesh = model(part);
    measures.walls.emplace();
    measures.walls->atCentres.resize(measures.mesh.triangles.size());
    for ([[maybe_unused]] auto round : state) {
        const auto start = std::chrono::steady_clock::now();
        if (part == Judging)
            benchmark::DoNotOptimize(core::checkForPrint(measures, {}));
        else if (part == Picture)
            benchmark::DoNotOptimize(core::pictureOf(measures, core::PrintPicture::Overhang));
        else
            benchmark::DoNotOptimize(core::wallThickness(measures.mesh, core::PrintLimits::largestBall));
        const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        state.SetIterationTime(seconds);
        state.counters["wall"] = 1000 * seconds;
    }
}
BENCHMARK(print)->DenseRange(0, 4)->Iterations(1)->UseManualTime();
} // namespace
