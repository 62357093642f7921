// Measures the cost of crash safety: the same strokes without and with a journal, on two models. The journal also
// writes new bases during the strokes.
#include "tests/bench/bench_models.h"
#include "tests/bench/bench_stroke.h"

#include "core/journal/compaction.h"
#include "core/journal/journal.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <unistd.h>

namespace
{
using bench::Clocks;
namespace fs = std::filesystem;

constexpr int strokes = 40, dabsPerStroke = 24;
/// Small limits, so that bases are written during the strokes.
constexpr core::JournalLimits limits{.segmentBytes = 128 << 10, .logBytes = 1 << 20};

/// A folder on this disk, removed by the destructor.
class Home
{
public:
    Home() : m_path(fs::temp_directory_path() / ("fettle-bench-journal-" + std::to_string(::getpid()))) {}
    ~Home() { fs::remove_all(m_path); }
    const fs::path& path() const { return m_path; }

private:
    fs::path m_path;
};

double percentile(std::vector<double> values, double part)
{
    std::ranges::sort(values);
    return values[std::min(values.size() - 1, static_cast<std::size_t>(part * static_cast<double>(values.size())))];
}

struct Costs
{
    std::vector<double> dabUs, endUs, copyUs; ///< wall-clock times of the mesh thread, microseconds
};

/// Sculpts short strokes all around the model and returns their times.
Costs sculpt(core::Sculptor& sculptor, double radius, core::Journal* journal)
{
    Costs costs;
    core::StrokeSettings settings;
    settings.radius = radius;
    for (int i = 0; i < strokes * dabsPerStroke; ++i) {
        if (i % dabsPerStroke == 0)
            sculptor.beginStroke(settings);
        const double angle = 0.126 * radius * i;
        core::StrokeSample sample;
        sample.position = {std::cos(angle), 0, std::sin(angle)};
        const Clocks start = Clocks::now();
        sculptor.addSample(sample);
        benchmark::DoNotOptimize(sculptor.takePatch());
        costs.dabUs.push_back(Clocks::now().since(start).wall);
        if (i % dabsPerStroke != dabsPerStroke - 1)
            continue;
        const Clocks beforeEnd = Clocks::now();
        const core::MeshDelta delta = sculptor.endStroke();
        const auto recordedStep = std::make_shared<const core::FileEntry>(core::Stroke{settings, {sample}, {}, {}});
        const Clocks ended = Clocks::now();
        costs.endUs.push_back(ended.since(beforeEnd).wall);
        if (journal)
            journal->changed(sculptor.mesh(), delta, {"Pull", "pull", dabsPerStroke, 0, recordedStep});
        costs.copyUs.push_back(Clocks::now().since(ended).wall);
    }
    return costs;
}

void report(benchmark::State& state, const std::string& what, const Costs& costs)
{
    state.counters[what + "_dab_us"] = percentile(costs.dabUs, 0.5);
    state.counters[what + "_dab_p99_us"] = percentile(costs.dabUs, 0.99);
    state.counters[what + "_end_us"] = percentile(costs.endUs, 0.5);
}

void journal(benchmark::State& state)
{
    const int divisions = static_cast<int>(state.range(0));
    const double radius = 0.0126 * 317 / divisions;
    const core::TriangleMesh& source = bench::geodesicSphere(divisions);
    state.SetLabel(divisions == 317 ? "1,004,892 vertices" : "39,692 vertices");
    for ([[maybe_unused]] auto round : state) {
        const Home home;
        core::Sculptor without(bench::opened(source)), with(bench::opened(source));
        report(state, "without", sculpt(without, radius, nullptr));
        const auto snapshot = core::snapshotOf(with.mesh());
        const Clocks beforeStart = Clocks::now();
        const auto kept = core::Journal::begin(home.path(), {snapshot, {"sphere", "", {}, false}}, {}, limits);
        state.counters["start_ms"] = 1e-3 * Clocks::now().since(beforeStart).wall;
        const Clocks beforeStrokes = Clocks::now();
        const Costs costs = sculpt(with, radius, kept.get());
        state.SetIterationTime(1e-6 * Clocks::now().since(beforeStrokes).wall);
        report(state, "with", costs);
        state.counters["copy_us"] = percentile(costs.copyUs, 0.5);
        state.counters["copy_worst_us"] = *std::ranges::max_element(costs.copyUs);
        kept->flush();
        const core::JournalStats stats = kept->stats();
        state.counters["bytes_a_dab"] = static_cast<double>(stats.bytes) / (strokes * dabsPerStroke);
        state.counters["pack_ms_a_stroke"] = stats.packMs / strokes;
        state.counters["write_ms_a_stroke"] = stats.writeMs / strokes;
        state.counters["worst_written_ms"] = stats.worstWrittenMs;
        state.counters["worst_synced_ms"] = stats.worstSyncedMs;
        while (kept->stats().isCompacting)
            ::usleep(1000);
        state.counters["compactions"] = static_cast<double>(kept->stats().compactions);
        const Clocks beforeReplay = Clocks::now();
        const auto found = core::recoverJournal(kept->folder());
        state.counters["recover_ms"] = 1e-3 * Clocks::now().since(beforeReplay).wall;
        if (!found || found->mesh->stateHash() != with.mesh().stateHash())
            state.SkipWithError("another model came back");
    }
}
BENCHMARK(journal)->Arg(63)->Arg(317)->Iterations(1)->UseManualTime()->Unit(benchmark::kMillisecond);
} // namespace
