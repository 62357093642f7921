#pragma once

#include "core/geometry/triangle_mesh.h"
#include "core/sculpt/sculptor.h"

#include <memory>
#include <vector>

/// Shapes that sculpting tests work on: closed, facing outwards, free of self-intersections, about one unit large.
namespace clay
{
using core::Slot;
using core::TriangleMesh;

/// A square plate in the plane y = 0, `cells` x `cells` on each side.
TriangleMesh slab(double side, double thickness, Slot cells);
/// Turned about the y axis from points (radius, height) that run from the lower pole up, the outside on their right;
/// both poles, with radius 0, included.
TriangleMesh revolved(const std::vector<core::Vec3>& profile, Slot around);
TriangleMesh bowl();
/// A round tube around a path in the plane z = 0, with round ends. Parts of the path farther apart than twice the
/// radius.
TriangleMesh tube(const std::vector<core::Vec3>& path, double radius, Slot around);
/// A ring of radius 1 and thickness 0.5 that was cut: its round ends face each other at angle 0, `gap` apart.
TriangleMesh cutRing(double gap);
/// A tube wound two and a half times in a plane, the windings a tenth of their thickness apart.
TriangleMesh spiral();
/// Two long balls side by side, `gap` apart at their nearest.
TriangleMesh twoFingers(double gap);

constexpr double ballRadius = 50; ///< millimetres

std::unique_ptr<core::Sculptor> ball(int subdivisions = 5);
/// A ball of radius 1.
std::unique_ptr<core::Sculptor> unitBall();
/// A stroke of one dab.
core::DabReport dabOnce(core::Sculptor& sculptor, const core::StrokeSettings& settings, const core::Vec3& position,
                        const core::Vec3& direction = -core::Vec3::UnitZ());
/// Returns what each dab did. Samples point to the middle of the ball.
std::vector<core::DabReport> stroke(core::Sculptor& sculptor, const core::StrokeSettings& settings,
                                    const std::vector<core::Vec3>& path);
} // namespace clay
