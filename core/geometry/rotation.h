#pragma once

#include "core/geometry/geometry.h"

namespace core
{
/// Returns the smallest rotation that takes one direction to the other, accurate to 1e-7. Opposite directions give a
/// half turn about any perpendicular axis. Precondition: the vectors are not zero; any length is allowed. Replaces
/// Eigen's FromTwoVectors(), whose singular value decomposition costs each file that calls it 15 s of compile time.
inline Eigen::Quaterniond rotationBetween(const Vec3& from, const Vec3& to)
{
    const Vec3 a = from.normalized(), sum = a + to.normalized();
    const Vec3 half = sum.norm() < 1e-8 ? a.unitOrthogonal() : sum.normalized();
    const Vec3 axis = a.cross(half);
    return Eigen::Quaterniond(a.dot(half), axis.x(), axis.y(), axis.z()).normalized();
}
} // namespace core
