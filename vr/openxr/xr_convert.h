#pragma once

#include "vr/util/pose.h"

#include <openxr/openxr.h>

namespace vr
{
/// Converts a pose from OpenXR, which uses the same axes but floats. Normalises the rotation.
Pose fromXr(const XrPosef& pose);
/// Converts a pose to OpenXR.
XrPosef toXr(const Pose& pose);

/// Returns whether all coordinates are finite. A runtime may report others as valid; they would spread to everything
/// computed from them.
bool isFinitePosition(const XrVector3f& place);
/// Returns whether the quaternion can be normalised: its length is between 0.5 and 2. OpenXR requires 1, within 0.01.
bool isRotation(const XrQuaternionf& rotation);

/// Returns whether the runtime knows both position and orientation, and both are usable numbers.
bool isValid(const XrSpaceLocation& location);
/// Returns whether both position and orientation are valid and tracked at this time, not remembered or guessed.
bool isTracked(const XrSpaceLocation& location);

/// Returns the projection from view space to OpenGL's clip space. Units: metres.
Eigen::Matrix4f projectionOf(const XrFovf& fov, float nearPlane, float farPlane);

/// Returns the pose of a level room whose origin is below this head at height 0, and whose -Z is where the head looks.
/// If the head looks nearly straight up or down, the direction of its chin or of its top replaces the view direction.
Pose levelBelow(const Pose& head);
} // namespace vr
