#pragma once

#include "core/geometry/lattice_box.h"

#include <algorithm>
#include <span>
#include <vector>

namespace core
{
// Groups boxes into clusters that are separated by empty slabs. Thread: any.

/// Returns an axis along which no box crosses the middle plane of `all`, or 3 if there is none.
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

/// Appends one bounding box for each cluster of `boxes`, and reorders `boxes`. If each box bounds connected elements,
/// no elements of different clusters are connected. Cost: O(boxes) for each cluster.
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
