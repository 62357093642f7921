#pragma once

#include "core/io/mesh/format.h"

#include "core/geometry/triangle_mesh.h"

#include <span>

namespace core::io
{
/// Appends the triangles of a face with at least four corners: ears, one after the other around it, in the plane in
/// which it is largest. Exact: a simple polygon is filled and nothing else. Corners are looked for in a grid, so that
/// the cost is some hundred questions a corner, whatever their number; shapes whose parts all lie across each other
/// take the square of it. Throws ReadingCancelled.
void clipEars(std::vector<Triangle>& triangles, const std::vector<Vec3f>& points, std::span<const Slot> corners,
              StopCheck& stopCheck);
} // namespace core::io
