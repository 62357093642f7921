#pragma once

#include "vr/simulator/call_failure.h"

#include "vr/util/pose.h"

#include <cmath>

namespace simulator
{
inline XrVector3f toXr(const core::Vec3& v)
{
    return {static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z())};
}

inline XrPosef toXr(const vr::Pose& pose)
{
    const Eigen::Quaternionf q = pose.rotation.cast<float>();
    return {{q.x(), q.y(), q.z(), q.w()}, toXr(pose.position)};
}

/// Converts a pose from OpenXR. Fails if the rotation is no unit quaternion within the specification's 1 %, or if the
/// position is not finite.
inline vr::Pose fromXr(const XrPosef& pose)
{
    const Eigen::Quaterniond rotation(static_cast<double>(pose.orientation.w), static_cast<double>(pose.orientation.x),
                                      static_cast<double>(pose.orientation.y), static_cast<double>(pose.orientation.z));
    const core::Vec3 position(static_cast<double>(pose.position.x), static_cast<double>(pose.position.y),
                              static_cast<double>(pose.position.z));
    require(std::abs(rotation.norm() - 1) <= 0.01, XR_ERROR_POSE_INVALID, "a rotation is no unit quaternion");
    require(position.allFinite(), XR_ERROR_POSE_INVALID, "a position is not finite");
    return {rotation.normalized(), position};
}
} // namespace simulator
