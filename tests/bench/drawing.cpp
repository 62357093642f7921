// What three views of a model of a million vertices cost: as the 2D preview draws them while strokes go on, and when they rest.
#include "bench_models.h"

#include "core/line_drawing.h"
#include "core/sculptor.h"

#include <benchmark/benchmark.h>

#include <chrono>

namespace
{
void drawing(benchmark::State& state)
{
    const core::DrawingDetail details[] = {{512, false, 40'000}, {512, true, 40'000}, {2048, false, 300'000}};
    const char* const labels[] = {"512 pixels, lines", "512 pixels, shaded", "2048 pixels, lines"};
    state.SetLabel(labels[state.range(0)]);
    core::DrawArrays model;
    model.apply(core::Sculptor(bench::opened(bench::geodesicSphere(317))).wholePatch());
    for ([[maybe_unused]] auto round : state) {
        const auto start = std::chrono::steady_clock::now();
        benchmark::DoNotOptimize(core::drawLines(model, details[state.range(0)], {}));
        const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        state.SetIterationTime(seconds);
        state.counters["wall"] = 1000 * seconds;
    }
}
BENCHMARK(drawing)->DenseRange(0, 2)->Iterations(1)->UseManualTime();
} // namespace
