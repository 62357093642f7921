#pragma once

#include "core/repair/triangle_soup.h"

#include "core/analysis/self_intersection.h"
#include "core/geometry/box_tree.h"

#include <span>
#include <vector>

namespace core::repair
{
/// Returns the boxes of the faces that have one of these points as a corner, enlarged by `margin` (lattice units).
std::vector<FaceBox> boxesAround(const TriangleSoup& surface, std::span<const Slot> points, float margin);

/// Returns the faces whose boxes meet one of these boxes, ascending. Cost: a tree of the boxes, and one query per face
/// of the surface.
std::vector<Slot> facesNear(const TriangleSoup& surface, const std::vector<FaceBox>& boxes);

/// Returns the pairs of these faces that meet. Precondition: `faces` are ascending.
IntersectionReport intersectionsAmong(const TriangleSoup& surface, std::span<const Slot> faces, std::size_t maxPairs,
                                      const std::stop_token& stop);
} // namespace core::repair
