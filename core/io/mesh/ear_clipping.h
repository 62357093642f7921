#pragma once

#include "core/io/mesh/format.h"

#include "core/geometry/triangle_mesh.h"

#include <span>

namespace core::io
{
/// Triangulates a face with at least four corners by ear clipping, projected along the axis in which its area is
/// largest. Appends the triangles. The tests are exact: a polygon is filled exactly if it is simple, or touches itself
/// only at corners and along edges, as one whose holes are joined to its outline. Cost: about the square root of the
/// number of corners for each, thanks to a tree. Throws ReadingCancelled.
void clipEars(std::vector<Triangle>& triangles, const std::vector<Vec3f>& points, std::span<const Slot> corners,
              StopCheck& stopCheck);
} // namespace core::io
