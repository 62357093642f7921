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
    double length = 0, width = 0; ///< size of the largest sheet, lattice units
    double volume = 0;            ///< volume of the sheets as if they were closed, lattice units^3
    /// Faces of the sheets with 1/100 of the whole area or more.
    std::vector<Triangle> largeOnes;
};

/// Removes sheets: open parts that enclose nothing. Parts are connected by edges of two faces; a fin on an edge of a
/// solid is one. A part is a sheet if three conditions hold:
///   - Closing it would add more than three quarters of its area.
///   - The closed part would be flat: at most a tenth of the volume of the ball with its area.
///   - The other faces are closed without it: when other sheets are removed, the winding number of the other faces at
///     the part is on average within a quarter of a whole number.
/// Precondition: the surface is oriented. Cost: that of fillHoles(), and winding numbers at 64 faces per part.
SheetRemoval removeSheets(TriangleSoup& surface, const JobControl& control = {});
} // namespace core::repair
