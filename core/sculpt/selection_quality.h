#pragma once

#include "core/sculpt/select/region.h"

namespace core
{
/// Measures how close a selection is to quasi-uniform (paper, section 3.2), and how well its faces are shaped. Counts
/// edges with both ends selected and faces with all corners selected.
struct SelectionQuality
{
    /// length of the longest edge, in units of d_detail; at most 1 if the selection is d_detail-tight
    double longestEdge = 0;
    double conformingShare = 0;   ///< share of the edges that are at least d long, 0 to 1
    double smallestAngleSine = 0; ///< sine of the smallest angle of a face; 1st percentile over the faces
};

/// Returns the quality of the selection; nothing if no face is selected. Cost: O(selection log selection).
std::optional<SelectionQuality> selectionQuality(const Mesh& mesh, const Region& region, const EdgeBounds& bounds);
} // namespace core
