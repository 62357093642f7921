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

/// Thickness of the matter in the model's unit: the diameter of a ball that touches a point of a face from within and,
/// on the other side, a face in sight that looks more than 120 degrees away, or an edge that juts into the matter
/// there. An edge sharper than 60 degrees is a thin place, the thinner the nearer to it; it is followed down to about
/// 0.1. Infinity where nothing is opposite, and behind a face without area.
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
};

/// The model bounds a solid. Balls are sought among those not larger than `largestBall` (those of parts among all);
/// where none is found, what the rays found stands for it. All cores; the result does not depend on their number. Time
/// and space: see fettle_bench; 150 bytes a face. If it is cancelled, the result is not usable.
WallThickness wallThickness(const TriangleMesh& mesh, double largestBall, const JobControl& control = {});
} // namespace core
