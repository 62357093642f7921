#pragma once

#include "core/geometry/geometry.h"

namespace vr
{
/// A position and an orientation. Room space is right-handed, in metres, with Y up and the floor at y = 0. Forward is
/// the pose's own -Z.
struct Pose
{
    Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
    core::Vec3 position = core::Vec3::Zero();

    core::Vec3 forward() const { return rotation * -core::Vec3::UnitZ(); }
    core::Vec3 operator*(const core::Vec3& own) const { return rotation * own + position; }
    Pose operator*(const Pose& own) const { return {rotation * own.rotation, *this * own.position}; }
    Pose inverse() const { return {rotation.conjugate(), rotation.conjugate() * -position}; }
    Eigen::Affine3d matrix() const { return Eigen::Translation3d(position) * rotation; }
};
} // namespace vr
