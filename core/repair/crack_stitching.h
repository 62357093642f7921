#pragma once

#include "core/repair/triangle_soup.h"

#include <cstddef>

namespace core::repair
{
struct StitchResult
{
    std::size_t vertices = 0; ///< that moved to where another lies, or became corners of the face across a crack
    double farthest = 0;      ///< lattice units that a vertex moved, or an edge that it split
};

/// Closes cracks: open vertices that lie as good as on each other become one, and open edges are split where open
/// vertices lie as good as on them, if each part then lies along another open edge. As good as: within 1/5000 of the
/// surface's longest side, and within a quarter of the shortest edge at the vertex, so that no edge is lost. No other
/// vertex moves. The caller tidies afterwards.
StitchResult stitchCracks(TriangleSoup& surface);
} // namespace core::repair
