#pragma once

#include "core/triangle_mesh.h"

/// Shapes that sculpting tests work on: closed, facing outwards, free of self-intersections, about one unit large.
namespace clay
{
using core::Slot;
using core::TriangleMesh;

/// A square plate in the plane y = 0, `cells` x `cells` on each side.
TriangleMesh slab(double side, double thickness, Slot cells);
/// Turned about the y axis from points (radius, height) that run from the lower pole up, the outside on their right; both
/// poles, with radius 0, included.
TriangleMesh revolved(const std::vector<core::Vec3>& profile, Slot around);
TriangleMesh bowl();
/// Two long balls side by side, `gap` apart at their nearest.
TriangleMesh twoFingers(double gap);
} // namespace clay
