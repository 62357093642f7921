#pragma once

#include "core/sculpt/sculptor.h"

#include <benchmark/benchmark.h>

namespace bench
{
/// A stroke for comparison with other programs: dabs on a great circle of the sphere of radius 1.
struct GreatCircle
{
    core::Tool tool = core::Tool::Pull;
    double radius = 0.25;
    double strength = 0.2; ///< strength 0.2: each dab moves the surface by 0.02 radii of the brush
    double detail = 1;     ///< factor of d_detail; with factor 1, d_detail is sqrt(0.05) brush radii
    int dabs = 200;
    double spacing = 0.126; ///< distance between dabs, in radii of the brush
};

/// CPU time of the calling thread, CPU time of all threads of the program, and wall time, in microseconds.
struct Clocks
{
    double thread = 0, program = 0, wall = 0;
    static Clocks now();
    Clocks since(const Clocks& start) const;
};

/// Sculpts the stroke and sets counters. Units: microseconds per dab, including its patch for viewers.
/// Medians: cpu (calling thread), cpu_all (all threads), wall, per_vertex, verify, patch. 99th percentiles: cpu_p99,
/// wall_p99. First dab: cpu_first.
/// Means without the first dab, which is how Blender is timed: wall_mean, cpu_all_mean. Mean of the whole stroke:
/// per_vertex_mean.
/// `stroke`: time to begin and end the stroke, in microseconds.
/// Other counters: `touched`, vertices per dab (median); `whole`, share of dabs that committed on the fast path with
/// all of their displacement; `vertices` of the mesh.
void measure(benchmark::State& state, core::Sculptor& sculptor, const GreatCircle& stroke);
} // namespace bench
