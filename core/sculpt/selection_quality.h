#pragma once

#include "core/sculpt/select/region.h"

namespace core
{
/// How close a selection is to quasi-uniform (paper, section 3.2), and how well its faces are shaped. Edges count if
/// both ends are selected, faces if all corners are.
struct SelectionQuality
{
    double longestEdge = 0;       ///< in d_detail; d_detail-tight: at most 1
    double conformingShare = 0;   ///< share of the edges that are at least d long
    double smallestAngleSine = 0; ///< 1st percentile over the faces, of the sine of a face's smallest angle
};

/// Returns nothing if no face is selected. Cost: O(selection log selection).
std::optional<SelectionQuality> selectionQuality(const Mesh& mesh, const Region& region, const EdgeBounds& bounds);
} // namespace core
