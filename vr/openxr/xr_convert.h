#pragma once

#include "vr/util/pose.h"

#include <openxr/openxr.h>

namespace vr
{
/// Converts a pose from OpenXR, whose axes are ours and whose numbers are floats. Normalises the rotation.
Pose fromXr(const XrPosef& pose);
/// Converts a pose to OpenXR.
XrPosef toXr(const Pose& pose);

/// Whether all coordinates are finite. A runtime may call others valid, and they would spread to all that is computed
/// from them.
bool isFinitePosition(const XrVector3f& place);
/// Whether the quaternion can be normalised: its length is between 0.5 and 2. OpenXR asks for 1, within a hundredth.
bool isRotation(const XrQuaternionf& rotation);

/// Whether the runtime knows both position and orientation, and both are numbers that can be used.
bool isValid(const XrSpaceLocation& location);
/// Whether both position and orientation are valid, and tracked at this very time, not remembered or guessed.
bool isTracked(const XrSpaceLocation& location);

/// Returns the projection from view space to OpenGL's clip space. Units: metres.
Eigen::Matrix4f projectionOf(const XrFovf& fov, float nearPlane, float farPlane);

/// Returns the pose of a level room with its origin below this head, at height 0, and its -Z where the head looks. If
/// the head looks nearly straight up or down, the direction of its chin or of its top takes the place of its view.
Pose levelBelow(const Pose& head);
} // namespace vr
