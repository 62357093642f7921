#pragma once

#include "core/repair/triangle_soup.h"

#include "core/util/job_control.h"

#include <cstddef>
#include <vector>

namespace core::repair
{
struct SheetRemoval
{
    std::size_t sheets = 0;
    double length = 0, width = 0;    ///< of the largest one, lattice units
    double volume = 0;               ///< lattice units^3, that they would have if they were closed
    std::vector<Triangle> largeOnes; ///< faces of sheets with 1/100 of the area of all or more
};

/// Removes open parts that enclose nothing: what would close such a part has more than three quarters of its area, it
/// would be flat then (a tenth of the volume of the ball with its area, at most), and the other faces do not need it to
/// be closed either: once other sheets are gone, their winding numbers at its faces are on average within a quarter of
/// a whole number. Parts are connected by edges of two: a fin on an edge of a solid is one. The surface is oriented.
/// Cost: as fillHoles(), and winding numbers at 64 faces a part.
SheetRemoval removeSheets(TriangleSoup& surface, const JobControl& control = {});
} // namespace core::repair
