#pragma once

#include "core/repair/triangle_soup.h"

#include "core/util/job_control.h"

#include <cstddef>

namespace core::repair
{
struct HoleFillingResult
{
    std::size_t holes = 0;
    std::size_t faces = 0;      ///< number of faces added
    std::size_t largeHoles = 0; ///< number of large holes: filled if `largeToo` was true, otherwise left open
    double share = 0;           ///< added area as a share of the area before
};

/// A hole is large if the longest side of its box exceeds this share of the longest side of the surface's box.
inline constexpr double largeHole = 0.25;

/// Closes the loops at which the surface ends with faces of the least total area (Barequet and Sharir 1995). Loops that
/// bound one opening together, as the rims at the end of a pipe do, are filled together, up to 600 corners. A loop
/// consists of edges that faces run along more often in one direction than in the other. Loops of more than 300 corners
/// first lose their most pointed corners. New faces may meet other faces. Precondition: the surface is oriented.
HoleFillingResult fillHoles(TriangleSoup& surface, bool largeToo, const JobControl& control = {});
} // namespace core::repair
