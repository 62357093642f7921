#pragma once

#include "core/sculpt/sculptor.h"

#include <random>
#include <string>

/// Random strokes that are equal on every machine. Does not use the distributions of the standard library, whose
/// results may differ.
class StrokeFuzzer
{
public:
    explicit StrokeFuzzer(std::uint64_t seed) : m_engine(seed) {}

    double uniform() { return static_cast<double>(m_engine() >> 11) * 0x1p-53; } ///< uniformly distributed in [0, 1)
    double uniform(double low, double high) { return low + (high - low) * uniform(); }
    std::uint64_t below(std::uint64_t n) { return m_engine() % n; }
    core::Vec3 direction();

    /// Returns a stroke near the current mesh with a random tool, brush, topology, placement, fusion, spacing,
    /// airbrush, falloff and detail (0.3 to 3). One in three is mirrored, one in five has an alpha. The radius is
    /// between three edges and half the model's size, the strength up to 10.
    core::Stroke stroke(const core::Mesh& mesh);
    /// Returns a pull by 0.4 to 1 radii at a vertex of a mesh about as large as the ball of radius 1.
    core::Stroke strongPull(const core::Mesh& mesh);

private:
    core::Slot liveVertex(const core::Mesh& mesh);

    std::mt19937_64 m_engine;
};
