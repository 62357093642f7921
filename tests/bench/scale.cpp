// Measures how the cost of a dab grows with the sizes of models, brushes and displacements.
#include "tests/bench/bench_models.h"
#include "tests/bench/bench_stroke.h"
#include "tests/support/stroke_fuzzer.h"

#include <cstdlib>

namespace
{
using bench::GreatCircle;
using core::Sculptor;
using core::Slot;

enum Order { AsBuilt, Shuffled };

std::string thousands(Slot n)
{
    const std::string digits = std::to_string(n);
    std::string text;
    for (std::size_t i = 0; i < digits.size(); ++i)
        text += (i > 0 && (digits.size() - i) % 3 == 0 ? "," : "") + digits.substr(i, 1);
    return text;
}

core::TriangleMesh source(Slot cuts, Order order)
{
    return order == Shuffled ? bench::shuffled(bench::geodesicSphere(cuts)) : bench::geodesicSphere(cuts);
}

/// Measures strokes that touch about 160 vertices per dab. Arguments: parts into which each edge of the icosahedron is
/// cut, brush radius in units of 1e-6 sphere radii, order of the file.
void peersStroke(benchmark::State& state)
{
    const auto cuts = static_cast<Slot>(state.range(0));
    const auto order = static_cast<Order>(state.range(2));
    state.SetLabel(thousands(10 * cuts * cuts + 2) + " vertices" + (order == Shuffled ? ", shuffled file" : ""));
    for ([[maybe_unused]] auto round : state) {
        Sculptor sculptor(bench::opened(source(cuts, order)));
        bench::measure(state, sculptor, {.radius = 1e-6 * static_cast<double>(state.range(1))});
    }
}
BENCHMARK(peersStroke)
    ->ArgNames({"cuts", "radius_e-6", "shuffled"})
    ->Args({16, 250'000, AsBuilt})
    ->Args({64, 62'500, AsBuilt})
    ->Args({128, 31'000, AsBuilt})
    ->Args({256, 15'600, AsBuilt})
    ->Args({317, 12'600, AsBuilt})
    ->Args({64, 62'500, Shuffled})
    ->Args({128, 31'000, Shuffled})
    ->Args({256, 15'600, Shuffled})
    ->Args({317, 12'600, Shuffled})
    ->Iterations(1)
    ->UseManualTime()
    ->Unit(benchmark::kMicrosecond);

/// Makes `dabs` dabs all over the model, in strokes of 20 dabs with pull, push, flatten or smooth, chosen at random.
void age(Sculptor& sculptor, double radius, std::uint64_t dabs)
{
    constexpr core::Tool tools[] = {core::Tool::Pull, core::Tool::Push, core::Tool::Flatten, core::Tool::Smooth};
    constexpr std::uint64_t dabsPerStroke = 20;
    StrokeFuzzer random(20240812);
    for (std::uint64_t done = 0; done < dabs; done += dabsPerStroke) {
        core::StrokeSettings settings;
        settings.tool = tools[random.below(4)];
        settings.place = core::Placement::Nearest;
        settings.radius = radius;
        settings.strength = 0.2;
        sculptor.beginStroke(settings);
        for (std::uint64_t i = 0; i < dabsPerStroke; ++i) {
            core::StrokeSample sample;
            sample.position = random.direction();
            sculptor.addSample(sample);
            sculptor.takePatch();
        }
        sculptor.endStroke();
    }
}

/// Measures the stroke of peersStroke on models that have already been sculpted. Runs only if FETTLE_AGED_DABS gives
/// the number of earlier dabs, for example 100000. Cost: minutes.
void agedStroke(benchmark::State& state)
{
    const char* wanted = std::getenv("FETTLE_AGED_DABS");
    const std::uint64_t dabs = wanted ? std::strtoull(wanted, nullptr, 10) : 0;
    const auto cuts = static_cast<Slot>(state.range(0));
    const double radius = 1e-6 * static_cast<double>(state.range(1));
    state.SetLabel(thousands(10 * cuts * cuts + 2) + " vertices, " + std::to_string(dabs) + " dabs before");
    if (dabs == 0) {
        state.SkipWithError("FETTLE_AGED_DABS says after how many dabs");
        return;
    }
    for ([[maybe_unused]] auto round : state) {
        Sculptor sculptor(bench::opened(bench::geodesicSphere(cuts)));
        age(sculptor, radius, dabs);
        bench::measure(state, sculptor, {.radius = radius});
    }
}
BENCHMARK(agedStroke)
    ->ArgNames({"cuts", "radius_e-6"})
    ->Args({64, 62'500})
    ->Args({128, 31'000})
    ->Args({256, 15'600})
    ->Args({317, 12'600})
    ->Iterations(1)
    ->UseManualTime()
    ->Unit(benchmark::kMicrosecond);

/// Measures dabs of large regions, at a detail that matches the model's edges. Arguments: parts into which each edge of
/// the icosahedron is cut, brush radius in units of 1e-6 sphere radii, detail in units of 1e-4, number of dabs.
void largeDab(benchmark::State& state)
{
    const auto cuts = static_cast<Slot>(state.range(0));
    const GreatCircle stroke = {.radius = 1e-6 * static_cast<double>(state.range(1)),
                                .detail = 1e-4 * static_cast<double>(state.range(2)),
                                .dabs = static_cast<int>(state.range(3))};
    state.SetLabel(thousands(10 * cuts * cuts + 2) + " vertices, radius " + std::to_string(stroke.radius).substr(0, 5));
    for ([[maybe_unused]] auto round : state) {
        Sculptor sculptor(bench::opened(bench::geodesicSphere(cuts)));
        bench::measure(state, sculptor, stroke);
    }
}
BENCHMARK(largeDab)
    ->ArgNames({"cuts", "radius_e-6", "detail_e-4", "dabs"})
    ->Args({64, 250'000, 2'500, 100})
    ->Args({128, 173'000, 1'792, 100}) // these values make a dab touch 5,000 vertices
    ->Args({128, 250'000, 1'240, 100})
    ->Args({256, 250'000, 624, 40})
    ->Iterations(1)
    ->UseManualTime()
    ->Unit(benchmark::kMicrosecond);

/// Measures dabs of different displacements. Arguments: parts into which each edge of the icosahedron is cut, brush
/// radius in units of 1e-6 sphere radii, strength in percent.
void strength(benchmark::State& state)
{
    const auto cuts = static_cast<Slot>(state.range(0));
    const GreatCircle stroke = {.radius = 1e-6 * static_cast<double>(state.range(1)),
                                .strength = 1e-2 * static_cast<double>(state.range(2))};
    state.SetLabel(thousands(10 * cuts * cuts + 2) + " vertices, strength " +
                   std::to_string(stroke.strength).substr(0, 3));
    for ([[maybe_unused]] auto round : state) {
        Sculptor sculptor(bench::opened(bench::geodesicSphere(cuts)));
        bench::measure(state, sculptor, stroke);
    }
}
BENCHMARK(strength)
    ->ArgNames({"cuts", "radius_e-6", "strength_%"})
    ->Args({64, 62'500, 20})
    ->Args({64, 62'500, 100})
    ->Iterations(1)
    ->UseManualTime()
    ->Unit(benchmark::kMicrosecond);
/// Measures each tool on a fresh surface. Drag tools pull the surface sideways as far as possible without a fold.
void tools(benchmark::State& state)
{
    const auto tool = static_cast<core::Tool>(state.range(0));
    const bool drags = core::isDragTool(tool);
    state.SetLabel(std::string(core::name(tool)));
    for ([[maybe_unused]] auto round : state) {
        Sculptor sculptor(bench::opened(bench::geodesicSphere(64)));
        bench::measure(
            state, sculptor,
            {.tool = tool, .radius = 0.2, .strength = 1, .dabs = drags ? 10 : 60, .spacing = drags ? 0.05 : 0.4});
    }
}
BENCHMARK(tools)
    ->ArgName("tool")
    ->DenseRange(0, static_cast<int>(core::Tool::Mask))
    ->Iterations(1)
    ->UseManualTime()
    ->Unit(benchmark::kMicrosecond);

/// Drags the surface farther sideways than it can go without a fold. Arguments: tool, number of dabs of 0.1 radii each.
void drags(benchmark::State& state)
{
    const auto tool = static_cast<core::Tool>(state.range(0));
    const auto dabs = static_cast<int>(state.range(1));
    state.SetLabel(std::string(core::name(tool)));
    for ([[maybe_unused]] auto round : state) {
        Sculptor sculptor(bench::opened(bench::geodesicSphere(64)));
        bench::measure(state, sculptor, {.tool = tool, .radius = 0.2, .strength = 1, .dabs = dabs, .spacing = 0.1});
    }
}
BENCHMARK(drags)
    ->ArgNames({"tool", "dabs"})
    ->ArgsProduct({{static_cast<int>(core::Tool::Pull), static_cast<int>(core::Tool::Grab),
                    static_cast<int>(core::Tool::SnakeHook)},
                   {5, 10, 20, 40}})
    ->Iterations(1)
    ->UseManualTime()
    ->Unit(benchmark::kMicrosecond);
} // namespace
