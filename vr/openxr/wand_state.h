#pragma once

#include "vr/util/pose.h"

#include <Eigen/Core>

#include <array>
#include <cstddef>

namespace vr
{
enum class Side { Left, Right };
inline constexpr std::size_t sideCount = 2;

/// From the palm to a wand's front end, in metres: our own wand's, and nearly a Vive's.
inline constexpr double tipReach = 0.134;

/// What one wand says in one frame. Poses: room space, at the frame's predicted display time.
struct WandState
{
    bool isTracked = false; ///< the poses are of this frame, not of some time ago
    Pose grip;              ///< the palm
    Pose aim;               ///< where it points: -Z
    /// The runtime gives us its buttons: it is there, and we have the focus; else all below is at rest.
    bool isActive = false;
    double trigger = 0;                            ///< 0 to 1
    Eigen::Vector2d pad = Eigen::Vector2d::Zero(); ///< -1 to 1; x right, y away from the hand
    bool padTouched = false;
    bool padPressed = false;
    bool isStick = false;  ///< the pad is a thumbstick: it springs back to the middle
    bool isSimple = false; ///< it has a trigger and a menu button only
    bool side = false;     ///< squeezed, or a grip button
    bool menu = false;
};

using Wands = std::array<WandState, sideCount>; ///< by Side
} // namespace vr
