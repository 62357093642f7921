#include "tests/bench/bench_stroke.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <numeric>

namespace bench
{
namespace
{
double microseconds(clockid_t clock)
{
    timespec time{};
    clock_gettime(clock, &time);
    return 1e6 * static_cast<double>(time.tv_sec) + 1e-3 * static_cast<double>(time.tv_nsec);
}

class Values
{
public:
    void add(double value) { m_values.push_back(value); }
    double first() const { return m_values.front(); }
    double sum() const { return std::accumulate(m_values.begin(), m_values.end(), 0.0); }
    /// Returns the mean of all values except the first.
    double meanOfLater() const { return (sum() - first()) / static_cast<double>(m_values.size() - 1); }
    double median() { return percentile(0.5); }
    double percentile(double part)
    {
        std::ranges::sort(m_sorted = m_values);
        const auto index = static_cast<std::size_t>(part * static_cast<double>(m_sorted.size()));
        return m_sorted[std::min(m_sorted.size() - 1, index)];
    }

private:
    std::vector<double> m_values, m_sorted;
};

bool isWhole(const core::DabReport& report)
{
    return report.outcome == core::DabOutcome::Committed && report.reached >= 0.999 * report.asked;
}
} // namespace

Clocks Clocks::now()
{
    return {microseconds(CLOCK_THREAD_CPUTIME_ID), microseconds(CLOCK_PROCESS_CPUTIME_ID),
            microseconds(CLOCK_MONOTONIC)};
}

Clocks Clocks::since(const Clocks& start) const
{
    return {thread - start.thread, program - start.program, wall - start.wall};
}

void measure(benchmark::State& state, core::Sculptor& sculptor, const GreatCircle& stroke)
{
    core::StrokeSettings settings;
    settings.tool = stroke.tool;
    settings.radius = stroke.radius;
    settings.strength = stroke.strength;
    settings.detail = stroke.detail;
    Values cpu, all, wall, verify, patch, touched, perVertex;
    double whole = 0;

    const Clocks beforeStroke = Clocks::now();
    sculptor.beginStroke(settings);
    double ends = Clocks::now().since(beforeStroke).thread;
    for (int i = 0; i < stroke.dabs; ++i) {
        const double angle = stroke.spacing * stroke.radius * i;
        core::StrokeSample sample;
        sample.position = {std::cos(angle), 0, std::sin(angle)};
        const Clocks start = Clocks::now();
        const core::DabReport report = sculptor.addSample(sample).front();
        const Clocks dab = Clocks::now();
        benchmark::DoNotOptimize(sculptor.takePatch());
        const Clocks end = Clocks::now(), cost = end.since(start);
        cpu.add(cost.thread);
        all.add(cost.program);
        wall.add(cost.wall);
        patch.add(end.since(dab).thread);
        verify.add(1000 * report.verifyMs);
        touched.add(report.touchedVertices);
        perVertex.add(cost.thread / std::max(1u, report.touchedVertices));
        whole += isWhole(report);
    }
    const Clocks beforeEnd = Clocks::now();
    benchmark::DoNotOptimize(sculptor.endStroke());
    ends += Clocks::now().since(beforeEnd).thread;

    state.SetIterationTime(1e-6 * wall.median());
    state.counters["cpu"] = cpu.median();
    state.counters["cpu_p99"] = cpu.percentile(0.99);
    state.counters["cpu_first"] = cpu.first();
    state.counters["cpu_all"] = all.median();
    state.counters["cpu_all_mean"] = all.meanOfLater();
    state.counters["wall_mean"] = wall.meanOfLater();
    state.counters["wall"] = wall.median();
    state.counters["wall_p99"] = wall.percentile(0.99);
    state.counters["verify"] = verify.median();
    state.counters["patch"] = patch.median();
    state.counters["stroke"] = ends;
    state.counters["touched"] = touched.median();
    state.counters["per_vertex"] = perVertex.median();
    state.counters["per_vertex_mean"] = cpu.sum() / touched.sum();
    state.counters["whole"] = whole / stroke.dabs;
    state.counters["vertices"] = sculptor.mesh().live().vertices;
}
} // namespace bench
