#pragma once

#include "core/geometry/lattice_box.h"

#include <algorithm>
#include <span>
#include <vector>

namespace core
{
// What changed in several places at once, parted by empty slabs. Any thread.

/// Along which no box lies across the middle of the one around them all; 3: along none.
inline int separatingAxis(std::span<const LatticeBox> boxes, const LatticeBox& all)
{
    const auto isSeparating = [&](int axis) {
        const int twice = all.min[axis] + all.max[axis];
        return std::ranges::all_of(
            boxes, [=](const LatticeBox& box) { return 2 * box.max[axis] < twice || 2 * box.min[axis] > twice; });
    };
    int axis = 0;
    while (axis < 3 && !isSeparating(axis))
        ++axis;
    return axis;
}

/// Adds to the parts boxes around all of these, whose order changes: what lies in one part is connected with nothing in
/// another, if each box holds something connected. Cost: O(n) for each part.
inline void addClusters(std::span<LatticeBox> boxes, std::vector<LatticeBox>& clusters)
{
    if (boxes.empty())
        return;
    LatticeBox all;
    for (const LatticeBox& box : boxes)
        all.extend(box);
    const int axis = separatingAxis(boxes, all);
    if (axis == 3)
        return clusters.push_back(all);
    const auto above = std::ranges::partition(
        boxes, [&](const LatticeBox& box) { return 2 * box.max[axis] < all.min[axis] + all.max[axis]; });
    addClusters({boxes.begin(), above.begin()}, clusters);
    addClusters(above, clusters);
}
} // namespace core
