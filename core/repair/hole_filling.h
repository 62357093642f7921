#pragma once

#include "core/repair/triangle_soup.h"

#include "core/util/job_control.h"

#include <cstddef>

namespace core::repair
{
struct HoleFillingResult
{
    std::size_t holes = 0;
    std::size_t faces = 0;      ///< that were added
    std::size_t largeHoles = 0; ///< filled, or left open if `largeToo` was false
    double share = 0;           ///< of what was added, in the area that was there
};

/// A hole is large if its box is longer than this share of the surface's.
inline constexpr double largeHole = 0.25;

/// Closes the loops along which the surface ends (edges that faces do not run as often one way as the other) with the
/// least area (Barequet and Sharir 1995), up to 300 corners; longer loops lose their most pointed corners first. What
/// fills a hole may meet other faces. The surface is oriented.
HoleFillingResult fillHoles(TriangleSoup& surface, bool largeToo, const JobControl& control = {});
} // namespace core::repair
