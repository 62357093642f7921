#pragma once

#include "vr/util/pose.h"

#include <Eigen/Core>

#include <array>
#include <cstddef>

namespace vr
{
enum class Side { Left, Right };
inline constexpr std::size_t sideCount = 2;

/// Distance from the palm to the front end of a wand, in metres: exact for Fettle's model of a wand, about right for a
/// Vive's.
inline constexpr double tipReach = 0.134;

/// State of one wand in one frame. Poses are in room space, at the frame's predicted display time.
struct WandState
{
    bool isTracked = false; ///< the poses are measured for this frame, not remembered from an earlier one
    Pose grip;              ///< pose of the palm
    Pose aim;               ///< pose whose -Z is the direction that the wand points in
    Pose pinch;             ///< pose between the tips of thumb and index finger; valid for bare hands
    /// The wand is present and Fettle has the input focus. If false, the buttons below count as released and the pad as
    /// centred.
    bool isActive = false;
    double trigger = 0;                            ///< 0 (released) to 1 (pulled)
    Eigen::Vector2d pad = Eigen::Vector2d::Zero(); ///< -1 to 1 each; x to the right, y away from the palm
    bool padTouched = false;
    bool padPressed = false;
    bool isStick = false;  ///< the pad is a thumbstick, which springs back to the centre
    bool isSimple = false; ///< the wand has only a trigger and a menu button
    /// A bare hand: its trigger is the pinch of thumb and index finger, its grip the fist. It has no buttons.
    bool isHand = false;
    double squeeze = 0; ///< 0 (open) to 1 (squeezed) of the grip, or of a fist; a button is 0 or 1
    bool side = false;  ///< the grip is squeezed, or the grip button is pressed
    bool menu = false;
};

using Wands = std::array<WandState, sideCount>; ///< indexed by Side
} // namespace vr
