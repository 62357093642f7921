#pragma once

#include "core/repair/triangle_soup.h"

#include "core/analysis/self_intersection.h"
#include "core/geometry/box_tree.h"

#include <span>
#include <vector>

namespace core::repair
{
/// Boxes of the faces that have one of these points, grown by `margin` (lattice units).
std::vector<FaceBox> boxesAround(const TriangleSoup& surface, std::span<const Slot> points, float margin);

/// Faces whose boxes meet one of these, ascending. Cost: a tree of the boxes, and a question of it for each face.
std::vector<Slot> facesNear(const TriangleSoup& surface, const std::vector<FaceBox>& boxes);

/// Pairs of these faces that meet; faces ascending.
IntersectionReport intersectionsAmong(const TriangleSoup& surface, std::span<const Slot> faces, std::size_t maxPairs,
                                      const std::stop_token& stop);
} // namespace core::repair
