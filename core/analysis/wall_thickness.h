#pragma once

#include "core/geometry/triangle_mesh.h"
#include "core/util/job_control.h"

#include <vector>

namespace core
{
/// How thick the matter is behind each face, in the model's unit: the diameter of a ball that touches the face's centre
/// from within and, on the other side, a face that looks the other way (more than 120 degrees away: an edge is a thin
/// place if it is sharper than 60). Infinity where no face is opposite, and behind a face without area.
struct WallThickness
{
    std::vector<float> byRays; ///< by face; the least ball that one of a cone of five rays finds
    /// By face; the ball that no opposite face in sight reaches into, at most 7 % too large; never above byRays.
    std::vector<float> byBalls;
};

/// The model bounds a solid. Balls are sought among those not larger than `largestBall`; where none is found, what the
/// rays found stands for it. All cores; the result does not depend on their number. Time and space: see fettle_bench;
/// 150 bytes a face. If it is cancelled, the result is not usable.
WallThickness wallThickness(const TriangleMesh& mesh, double largestBall, const JobControl& control = {});
} // namespace core
