#include "ui/viewport/head_tracking.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ui
{
namespace
{
constexpr double timeConstant = 0.3; ///< seconds; slow enough to watch without motion sickness
/// exponent, odd; so large that the direction of the head's top affects the yaw only if the head looks almost straight
/// up or down
constexpr int steepness = 15;
} // namespace

OrbitCamera::Pose headTrackingStep(const OrbitCamera& camera, const Eigen::Isometry3d& head, double seconds)
{
    const core::Vec3 ahead = -head.linear().col(2), above = head.linear().col(1);
    const core::Vec3 level = ahead - std::pow(ahead.y(), steepness) * above;
    const double yaw = std::atan2(-level.x(), -level.z()), pitch = std::asin(std::clamp(-ahead.y(), -1.0, 1.0));

    const double share = 1 - std::exp(-seconds / timeConstant);
    const OrbitCamera::Pose now = camera.pose();
    return camera.standing(camera.eye() + share * (head.translation() - camera.eye()),
                           now.yaw + share * std::remainder(yaw - now.yaw, 2 * std::numbers::pi),
                           now.pitch + share * (pitch - now.pitch));
}
} // namespace ui
