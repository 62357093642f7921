#pragma once

#include "core/repair/triangle_soup.h"

#include "core/util/job_control.h"

#include <cstddef>

namespace core::repair
{
struct SheetRemoval
{
    std::size_t sheets = 0;
    double length = 0, width = 0; ///< the longer two sides of the largest one's box, lattice units
    double volume = 0;            ///< lattice units^3, that they would have if they were closed
};

/// Removes open parts that enclose nothing: what would close such a part has more than three quarters of its area, it
/// would be flat then (a tenth of the volume of the ball with its area, at most), and the other faces do not close it
/// either, that is, they wind around its middle by less than a quarter on average. Parts are connected by edges of
/// two: a fin on an edge of a solid is one. The surface is oriented. Cost: as fillHoles(), and winding numbers at 64
/// faces a part.
SheetRemoval removeSheets(TriangleSoup& surface, const JobControl& control = {});
} // namespace core::repair
