#pragma once

#include "core/repair/triangle_soup.h"

#include <cstddef>

namespace core::repair
{
struct StitchResult
{
    std::size_t vertices = 0; ///< vertices merged into others, or inserted into the edge across a crack
    /// Largest distance that a vertex moved, or of an inserted vertex from its edge, lattice units.
    double farthest = 0;
};

/// Closes cracks. Open vertices near each other are merged. Open edges are split at open vertices near them, if each
/// part then runs along another open edge. Near means within 1/5000 of the surface's longest side and within a quarter
/// of the shortest edge at the vertex, so that no edge is lost. No other vertex moves. The caller must call weld()
/// and cleanUp() afterwards.
StitchResult stitchCracks(TriangleSoup& surface);
} // namespace core::repair
