// Measures 2,000 pulls by 0.4 to 1 radii at random places of the paper's ball, and what they leave behind.
#include "tests/bench/bench_stroke.h"

#include "core/analysis/mesh_check.h"
#include "core/mesh/mesh_builder.h"
#include "tests/support/stroke_fuzzer.h"

#include <algorithm>
#include <vector>

namespace
{
constexpr int paperSubdivisions = 4, pulls = 2000;

void strongPulls(benchmark::State& state)
{
    state.SetLabel("seed " + std::to_string(state.range(0)));
    for ([[maybe_unused]] auto round : state) {
        core::Sculptor sculptor(core::buildMesh(core::icosphere(paperSubdivisions, 1)).mesh);
        StrokeFuzzer random(static_cast<std::uint64_t>(state.range(0)));
        std::vector<double> times;
        int whole = 0, early = 0;
        for (int i = 0; i < pulls; ++i) {
            const core::Stroke pull = random.strongPull(sculptor.mesh());
            sculptor.beginStroke(pull.settings);
            const bench::Clocks start = bench::Clocks::now();
            const core::DabReport report = sculptor.addSample(pull.samples.front()).front();
            times.push_back(bench::Clocks::now().since(start).thread / 1000);
            sculptor.endStroke();
            whole += report.isWhole();
            early += report.outcome == core::DabOutcome::EndedEarly;
        }
        std::ranges::sort(times);
        const core::MeshReport left = core::checkMesh(core::extractMesh(sculptor.mesh()));
        state.SetIterationTime(times[pulls / 2] / 1000);
        state.counters["whole"] = 100.0 * whole / pulls;
        state.counters["early"] = 100.0 * early / pulls;
        state.counters["cpu"] = times[pulls / 2];
        state.counters["cpu_p99"] = times[pulls * 99 / 100];
        state.counters["cpu_most"] = times.back();
        state.counters["genus"] = static_cast<double>(left.genus.value());
        state.counters["parts"] = static_cast<double>(left.components);
    }
}
BENCHMARK(strongPulls)->DenseRange(1, 3)->Iterations(1)->UseManualTime();
} // namespace
