// Measures a stroke on a ball of 50,412 vertices: alone, and as one of 20 such parts that overlap it.
#include "tests/bench/bench_models.h"
#include "tests/bench/bench_stroke.h"

#include "core/mesh/mesh_builder.h"
#include "core/parts/part_split.h"
#include "tests/support/shapes.h"
#include "tests/support/stroke_fuzzer.h"

#include <chrono>

namespace
{
constexpr core::Slot ballCuts = 71; ///< 50,412 vertices

std::unique_ptr<core::Mesh> balls(std::int64_t count)
{
    std::vector<core::PartPiece> pieces;
    StrokeFuzzer random(1);
    for (std::int64_t i = 0; i < count; ++i) {
        const core::Vec3f by = i == 0 ? core::Vec3f(core::Vec3f::Zero()) : random.direction().cast<float>();
        pieces.push_back({static_cast<core::PartId>(i),
                          shapes::moved(bench::geodesicSphere(ballCuts), {by.x(), by.y(), by.z()}),
                          {},
                          {}});
    }
    return core::buildMesh(core::joined(pieces)).mesh;
}

/// Returns the time to undo a stroke of one dab, microseconds.
double undoTime(core::Sculptor& sculptor)
{
    core::StrokeSettings settings;
    settings.radius = 0.25;
    sculptor.beginStroke(settings);
    core::StrokeSample sample;
    sample.position = {0, 0, 1};
    sculptor.addSample(sample);
    core::MeshDelta delta = sculptor.endStroke();
    const bench::Clocks start = bench::Clocks::now();
    sculptor.swap(delta);
    return bench::Clocks::now().since(start).wall;
}

void parts(benchmark::State& state)
{
    state.SetLabel(state.range(0) == 1 ? "alone" : "of 20 parts");
    for ([[maybe_unused]] auto round : state) {
        core::Sculptor sculptor(balls(state.range(0)));
        state.counters["undo"] = undoTime(sculptor);
        bench::measure(state, sculptor, {});
    }
}
BENCHMARK(parts)->Arg(1)->Arg(20)->Iterations(1)->Unit(benchmark::kMillisecond);
} // namespace
