#pragma once

#include "vr/util/pose.h"

#include <array>
#include <cstddef>

namespace vr
{
/// Number of a hand's joints, in the order of OpenXR's XrHandJointEXT: palm, wrist, four of the thumb and five of each
/// finger, from the wrist to the tip.
inline constexpr std::size_t jointCount = 26;

struct HandJoint
{
    core::Vec3 position = core::Vec3::Zero(); ///< room space
    double radius = 0.008;                    ///< distance from the joint to the skin, metres
};

using HandJoints = std::array<HandJoint, jointCount>;

/// Returns the joint to which a bone leads from this one, nearer to the wrist. The palm and the wrist have none and
/// return their own number.
constexpr std::size_t jointBefore(std::size_t joint)
{
    constexpr std::size_t wrist = 1, firstOfThumb = 2, firstOfFingers = 6, jointsOfFinger = 5;
    if (joint <= wrist)
        return joint;
    const bool isFirst =
        joint == firstOfThumb || (joint >= firstOfFingers && (joint - firstOfFingers) % jointsOfFinger == 0);
    return isFirst ? wrist : joint - 1;
}
} // namespace vr
