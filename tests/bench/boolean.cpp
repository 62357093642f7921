// Measures union, difference and intersection of two balls of a million triangles each, with the check of the result.
#include "tests/bench/bench_models.h"

#include "core/boolean/mesh_boolean.h"
#include "tests/support/shapes.h"

#include <benchmark/benchmark.h>

#include <array>
#include <chrono>
#include <stdexcept>

namespace
{
/// Returns two balls 100 mm wide that overlap by half a radius.
std::array<core::TriangleMesh, 2> balls()
{
    constexpr int cuts = 224; // 1,003,520 triangles
    const core::TriangleMesh ball = shapes::scaled(bench::geodesicSphere(cuts), 50);
    return {ball, shapes::moved(ball, {75, 3, 2})};
}

void boolean(benchmark::State& state)
{
    const char* const labels[] = {"union", "difference", "intersection"};
    state.SetLabel(labels[state.range(0)]);
    const std::array<core::TriangleMesh, 2> solids = balls();
    for ([[maybe_unused]] auto round : state) {
        const auto start = std::chrono::steady_clock::now();
        const core::BooleanResult result = core::combine(static_cast<core::SetOperation>(state.range(0)), solids);
        const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        if (!result.mesh)
            throw std::runtime_error("the balls cannot be combined");
        state.SetIterationTime(seconds);
        state.counters["wall"] = 1000 * seconds;
        state.counters["faces"] = static_cast<double>(result.report.faces);
    }
}
BENCHMARK(boolean)->DenseRange(0, 2)->Iterations(1)->UseManualTime();
} // namespace
