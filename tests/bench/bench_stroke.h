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
    double detail = 1;     ///< factor of d_detail, which is sqrt(0.05) brush radii
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

/// Sculpts the stroke and sets counters. Units: microseconds per dab, medians unless stated.
/// Medians and percentiles: cpu, cpu_p99, cpu_first (the first dab), cpu_all (all threads), wall, wall_p99, per_vertex,
/// verify, patch. Over the whole stroke: per_vertex_mean.
/// Means of all dabs except the first, which is how Blender is timed: wall_mean, cpu_all_mean. Beginning and ending the
/// stroke: stroke.
/// Other counters: touched (vertices); whole (share of dabs that committed on the fast path with all of their
/// displacement); vertices.
/// The times include all work that a dab needs, including its patch for viewers.
void measure(benchmark::State& state, core::Sculptor& sculptor, const GreatCircle& stroke);
} // namespace bench
