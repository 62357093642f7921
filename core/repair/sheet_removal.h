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
///   - The other faces are closed without it: once the other sheets are gone, the winding number of the other faces at
///     the part is on average within a quarter of a whole number.
///     Where no part that is left meets this, groups of up to 100 open parts near each other are judged, if each meets
///     the first two conditions. A part is a sheet if the absolute values of the mean winding numbers of the group's
///     other parts at it sum to at most a quarter, if the mean winding number of all other open parts together is at
///     most a quarter, and if the faces in no open part are closed there. These means are about 0 where sheets cross,
///     and a half at a side of a solid.
///     Where no part is one of these either, plane parts that meet the first two conditions are left out of the surface
///     together, and its holes are filled. Those are sheets whose points lie on the result within 1/1000 of their
///     width, or where the winding number of the other faces is within a quarter of a whole number; so that a lid on an
///     opening does not meet the faces that fill it.
/// Precondition: the surface is oriented. Cost: that of fillHoles(), and winding numbers at 64 faces per part; each
/// time that all parts fail, at 64 faces per pair of parts of a group, too. With plane parts: that of fillHoles() and
/// distancesTo() once more, seldom several times.
SheetRemoval removeSheets(TriangleSoup& surface, const JobControl& control = {});
} // namespace core::repair
