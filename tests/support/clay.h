#pragma once

#include "core/geometry/triangle_mesh.h"
#include "core/sculpt/sculptor.h"

#include <memory>
#include <vector>

/// Shapes for sculpting tests: closed, facing outwards, free of self-intersections, about one unit large.
namespace clay
{
using core::Slot;
using core::TriangleMesh;

/// Returns a square plate in the plane y = 0, with `cells` x `cells` squares on its top and its bottom.
TriangleMesh slab(double side, double thickness, Slot cells);
/// Returns the solid of a profile revolved about the y axis. The profile is (radius, height) points from the lower pole
/// to the upper one, with the outside on their right. Both poles are included and have radius 0.
TriangleMesh revolved(const std::vector<core::Vec3>& profile, Slot around);
TriangleMesh bowl();
/// Returns a round tube with round ends around a path in the plane z = 0. Precondition: parts of the path that are not
/// neighbours are farther apart than twice the radius.
TriangleMesh tube(const std::vector<core::Vec3>& path, double radius, Slot around);
/// Returns a ring of radius 1 and thickness 0.5 with a cut at angle 0: its round ends are `gap` apart.
TriangleMesh cutRing(double gap);
/// Returns a tube wound two and a half times in a plane, with a tenth of its radius between the windings.
TriangleMesh spiral();
/// Returns two elongated balls side by side, separated by `gap` at their closest points.
TriangleMesh twoFingers(double gap);

constexpr double ballRadius = 50; ///< radius of ball(), mm

std::unique_ptr<core::Sculptor> ball(int subdivisions = 5);
/// Returns a sculptor of a ball of radius 1.
std::unique_ptr<core::Sculptor> unitBall();
/// Sculpts a stroke of one dab and returns its report.
core::DabReport dabOnce(core::Sculptor& sculptor, const core::StrokeSettings& settings, const core::Vec3& position,
                        const core::Vec3& direction = -core::Vec3::UnitZ());
/// Sculpts a stroke along `path` and returns the report of each dab. Samples point towards the centre of the ball.
std::vector<core::DabReport> stroke(core::Sculptor& sculptor, const core::StrokeSettings& settings,
                                    const std::vector<core::Vec3>& path);
} // namespace clay
