#pragma once

#include "core/sculpt/sculptor.h"

#include <benchmark/benchmark.h>

namespace bench
{
/// The strokes that peers were measured on: pull dabs on a great circle of the sphere of radius 1, 0.126 radii apart.
struct GreatCircle
{
    core::Tool tool = core::Tool::Pull;
    double radius = 0.25;
    double strength = 0.2; ///< 0.2: dabs of 0.02 radii
    double detail = 1;     ///< scales d_detail, sqrt(0.05) radii
    int dabs = 200;
    double spacing = 0.126; ///< in radii
};

/// Times of the calling thread, of all threads of the program, and on the wall, in microseconds.
struct Clocks
{
    double thread = 0, program = 0, wall = 0;
    static Clocks now();
    Clocks since(const Clocks& start) const;
};

/// Does the stroke and sets counters, in microseconds a dab: cpu, cpu_p99, cpu_first, cpu_all (of all threads), wall,
/// wall_p99, per_vertex, verify, patch, of which medians where no word says otherwise; per_vertex_mean (of the whole
/// stroke); the means of all but the first dab, which is how Blender is timed, wall_mean and cpu_all_mean; stroke (to
/// begin and to end it). Besides: touched; whole (the share of dabs that committed on the straight path with all of
/// their displacement); vertices. All that a dab needs is in its times, its patch for viewers too.
void measure(benchmark::State& state, core::Sculptor& sculptor, const GreatCircle& stroke);
} // namespace bench
