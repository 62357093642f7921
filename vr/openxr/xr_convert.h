#pragma once

#include "vr/util/pose.h"

#include <openxr/openxr.h>

namespace vr
{
/// Between OpenXR's values and ours: the axes are the same, its numbers are floats.
Pose fromXr(const XrPosef& pose);
XrPosef toXr(const Pose& pose);

/// They are numbers, and a rotation is one: a runtime that calls something else known would spoil all that is done with
/// it, once for all.
bool isFinitePosition(const XrVector3f& place);
bool isRotation(const XrQuaternionf& rotation);

/// Both parts of a pose are known; else what they say means nothing.
bool isValid(const XrSpaceLocation& location);
/// Both parts of it are seen at this very time, not remembered or guessed.
bool isTracked(const XrSpaceLocation& location);

/// OpenGL's clip space; near and far in metres.
Eigen::Matrix4f projectionOf(const XrFovf& fov, float nearPlane, float farPlane);

/// A room that has its origin below this head and its -Z where the head looks, level. Of a head that looks straight up
/// or down its top, or what is opposite, says where that is.
Pose levelBelow(const Pose& head);
} // namespace vr
