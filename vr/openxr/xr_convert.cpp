#include "vr/openxr/xr_convert.h"

#include <cmath>

namespace vr
{
namespace
{
bool hasAll(XrSpaceLocationFlags flags, XrSpaceLocationFlags wanted)
{
    return (flags & wanted) == wanted;
}
} // namespace

Pose fromXr(const XrPosef& pose)
{
    const XrQuaternionf& q = pose.orientation;
    const XrVector3f& p = pose.position;
    return {Eigen::Quaternionf(q.w, q.x, q.y, q.z).cast<double>().normalized(), {p.x, p.y, p.z}};
}

XrPosef toXr(const Pose& pose)
{
    const Eigen::Quaternionf q = pose.rotation.cast<float>();
    const Eigen::Vector3f p = pose.position.cast<float>();
    return {{q.x(), q.y(), q.z(), q.w()}, {p.x(), p.y(), p.z()}};
}

bool isFinitePosition(const XrVector3f& place)
{
    return std::isfinite(place.x) && std::isfinite(place.y) && std::isfinite(place.z);
}

bool isRotation(const XrQuaternionf& rotation)
{
    const float length = std::hypot(std::hypot(rotation.x, rotation.y), std::hypot(rotation.z, rotation.w));
    return length > 0.5F && length < 2;
}

bool isValid(const XrSpaceLocation& location)
{
    return hasAll(location.locationFlags,
                  XR_SPACE_LOCATION_ORIENTATION_VALID_BIT | XR_SPACE_LOCATION_POSITION_VALID_BIT) &&
           isFinitePosition(location.pose.position) && isRotation(location.pose.orientation);
}

bool isTracked(const XrSpaceLocation& location)
{
    return isValid(location) && hasAll(location.locationFlags, XR_SPACE_LOCATION_ORIENTATION_TRACKED_BIT |
                                                                   XR_SPACE_LOCATION_POSITION_TRACKED_BIT);
}

Eigen::Matrix4f projectionOf(const XrFovf& fov, float nearPlane, float farPlane)
{
    const float left = std::tan(fov.angleLeft), right = std::tan(fov.angleRight);
    const float down = std::tan(fov.angleDown), up = std::tan(fov.angleUp);
    const float depth = farPlane - nearPlane;
    Eigen::Matrix4f projection;
    projection << 2 / (right - left), 0, (right + left) / (right - left), 0,      //
        0, 2 / (up - down), (up + down) / (up - down), 0,                         //
        0, 0, -(farPlane + nearPlane) / depth, -2 * farPlane * nearPlane / depth, //
        0, 0, -1, 0;
    return projection;
}

Pose levelBelow(const Pose& head)
{
    /// The view is steep if the horizontal part of its unit direction is shorter than this.
    constexpr double steep = 0.1;
    core::Vec3 ahead = head.forward();
    if (std::hypot(ahead.x(), ahead.z()) < steep)
        ahead = head.rotation * core::Vec3::UnitY() * (ahead.y() > 0 ? -1 : 1);
    const double yaw = std::atan2(-ahead.x(), -ahead.z());
    return {Eigen::Quaterniond(Eigen::AngleAxisd(yaw, core::Vec3::UnitY())), {head.position.x(), 0, head.position.z()}};
}
} // namespace vr
