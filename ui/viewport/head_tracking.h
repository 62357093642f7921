#pragma once

#include "ui/scene/orbit_camera.h"

#include <Eigen/Geometry>

namespace ui
{
/// Returns the camera's pose `seconds` later on its smoothed way to the position and direction of a head (see
/// HeadsetAvatar). The pose stays level even if the head is tilted. The result does not depend on the number of steps.
OrbitCamera::Pose headTrackingStep(const OrbitCamera& camera, const Eigen::Isometry3d& head, double seconds);
} // namespace ui
