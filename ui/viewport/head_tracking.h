#pragma once

#include "ui/scene/orbit_camera.h"

#include <Eigen/Geometry>

namespace ui
{
/// Where the camera is so many seconds later on its way to where that head is and looks (see HeadsetAvatar): smoothed,
/// and level however the head is tilted. The result does not depend on the number of steps.
OrbitCamera::Pose headTrackingStep(const OrbitCamera& camera, const Eigen::Isometry3d& head, double seconds);
} // namespace ui
