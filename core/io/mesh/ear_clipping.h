#pragma once

#include "core/io/mesh/format.h"

#include "core/geometry/triangle_mesh.h"

#include <span>

namespace core::io
{
/// Triangulates a face with at least four corners by ear clipping, projected along the axis in which its area is
/// largest. Appends the triangles. The tests are exact: a simple polygon is filled exactly. Cost: about a hundred tests
/// a corner for any number of corners, thanks to a grid; quadratic in the corners if triangles are about as large as
/// the face. Throws ReadingCancelled.
void clipEars(std::vector<Triangle>& triangles, const std::vector<Vec3f>& points, std::span<const Slot> corners,
              StopCheck& stopCheck);
} // namespace core::io
