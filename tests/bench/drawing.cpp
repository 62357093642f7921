// Measures line drawings of a model of a million vertices: full drawings of three kinds, and the incremental drawings
// of the 2D preview during a stroke.
#include "tests/bench/bench_models.h"

#include "core/drawing/incremental_line_drawing.h"
#include "core/sculpt/sculptor.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cmath>

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

/// Measures the incremental drawing after every fifth dab of a stroke.
void drawingStroke(benchmark::State& state)
{
    const bool shaded = state.range(0) != 0;
    state.SetLabel(shaded ? "shaded" : "lines");
    core::Sculptor sculptor(bench::opened(bench::geodesicSphere(317)));
    core::IncrementalLineDrawing drawer(640, 40'000);
    drawer.apply(sculptor.wholePatch());
    drawer.draw(shaded, {});
    core::StrokeSettings settings;
    settings.radius = 0.1;
    std::vector<double> applied, drawn;
    for ([[maybe_unused]] auto round : state) {
        sculptor.beginStroke(settings);
        for (int i = 0; i < 200; ++i) {
            const double angle = 0.02 * i;
            core::StrokeSample sample;
            sample.position = {std::cos(angle), std::sin(angle), 0};
            sample.direction = -sample.position;
            sculptor.addSample(sample);
            if (i % 5 != 4)
                continue;
            const core::MeshPatch patch = sculptor.takePatch();
            const auto start = std::chrono::steady_clock::now();
            drawer.apply(patch);
            const auto middle = std::chrono::steady_clock::now();
            benchmark::DoNotOptimize(drawer.draw(shaded, {}));
            const auto end = std::chrono::steady_clock::now();
            applied.push_back(std::chrono::duration<double>(middle - start).count());
            drawn.push_back(std::chrono::duration<double>(end - middle).count());
        }
        sculptor.endStroke();
        std::ranges::sort(applied);
        std::ranges::sort(drawn);
        state.SetIterationTime(applied[applied.size() / 2] + drawn[drawn.size() / 2]);
        state.counters["apply"] = 1000 * applied[applied.size() / 2];
        state.counters["wall"] = 1000 * (applied[applied.size() / 2] + drawn[drawn.size() / 2]);
        state.counters["worst"] = 1000 * (applied.back() + drawn.back());
    }
}
BENCHMARK(drawingStroke)->DenseRange(0, 1)->Iterations(1)->UseManualTime();
} // namespace
