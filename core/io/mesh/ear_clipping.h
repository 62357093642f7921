#pragma once

#include "core/io/mesh/format.h"

#include "core/geometry/triangle_mesh.h"

#include <span>

namespace core::io
{
/// Triangulates a face with at least four corners by ear clipping, in the plane in which its area is largest, and
/// appends the triangles. Exact: a simple polygon is filled and nothing else. Cost: some hundred tests a corner,
/// whatever their number, since a grid finds those in a triangle; the square of the corners if triangles are about as
/// large as the face. Throws ReadingCancelled.
void clipEars(std::vector<Triangle>& triangles, const std::vector<Vec3f>& points, std::span<const Slot> corners,
              StopCheck& stopCheck);
} // namespace core::io
