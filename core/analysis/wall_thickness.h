#pragma once

#include "core/geometry/triangle_mesh.h"
#include "core/util/job_control.h"

#include <vector>

namespace core
{
/// A triangle within a face whose thickness is not the same all over.
struct WallPart
{
    Slot face = 0;
    std::array<Vec3f, 3> corners;
    float share = 1; ///< of its face's area
    /// The thinnest place, at most 4 % too large, and about the thickest (infinity: somewhere no face is opposite, or
    /// one much farther away).
    float least = 0, most = 0;
    float byRays = 0; ///< by rays from the thinnest place, never below `least`
    Vec3f thinnest = Vec3f::Zero();

    /// The share of the part, 0 to 1, that is thinner than that: as if its thickness grew evenly from least to most.
    double shareBelow(double thickness) const;
};

/// A piece of an edge that juts into the matter, or a corner that does: nearer to another one than its faces are to
/// what is opposite to them.
struct WallRidge
{
    Slot face = 0; ///< one of those at it
    std::array<Vec3f, 2> ends;
    float least = 0; ///< the thinnest place, at most 1 % too large
    Vec3f thinnest = Vec3f::Zero();

    /// Returns the area of a strip as wide as the wall is thick: what balls of that size touch around it.
    double area() const;
};

/// Thickness of the matter in the model's unit: the diameter of a ball that touches a point of the surface from within,
/// along a normal there, and on the other side reaches a point in sight with a normal more than 120 degrees away. The
/// chord between the two points leaves the first one within 30 degrees of its normal.
///   - A face has one normal. An edge, and a corner all of whose edges lie to one side of it, has all normals between
///     those of its faces. It counts if it juts into the matter, as the ground of a groove does (bent by more than 20
///     degrees) or the tip of a pit (its edges rise by more than 6 degrees), or if it juts far out of it, as the edges
///     of a thin three-sided spike do (matter of less than 80 degrees at it).
///   - Faces are measured against faces, edges and corners. Edges and corners that jut into the matter are measured
///     against each other, too: there the chord leaves the second point so, too.
///   - An edge sharper than 60 degrees is a thin place, and so is the tip of a sharp spike, the thinner the nearer to
///     it; it is followed down to about 0.1.
/// Infinity where nothing is opposite, and behind a face without area.
struct WallThickness
{
    std::vector<float> byRays; ///< by face, at its centre; the least ball that one of a cone of five rays finds
    /// Thickness by face, at its centre: the ball that no opposite face in sight reaches into, at most 4 % too large
    /// (with more than 100,000 faces 7 %); never above byRays.
    std::vector<float> byBalls;
    /// Parts of the faces for which the centre does not speak, because they are large for their thickness; by face, and
    /// together the whole of each such face. A face is divided where it is thinner than the largest ball, until each
    /// part's thickness differs by less than a tenth (of more than 100,000 faces a fifth), or there are about 200,000
    /// parts.
    std::vector<WallPart> parts;
    /// Ridges that are thinner than the faces at them, none thicker than the largest ball; by face.
    std::vector<WallRidge> ridges;
};

/// The model bounds a solid. Balls are sought among those not larger than `largestBall` (those of parts among all);
/// where none is found, what the rays found stands for it. Runs on all cores; the result does not depend on their
/// number. Time and space: see fettle_bench; 150 bytes a face. If it is cancelled, the result is not usable.
WallThickness wallThickness(const TriangleMesh& mesh, double largestBall, const JobControl& control = {});
} // namespace core
