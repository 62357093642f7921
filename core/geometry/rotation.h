#pragma once

#include "core/geometry/geometry.h"

namespace core
{
/// Returns the smallest rotation that takes one direction to the other within 1e-7: a half turn about any
/// perpendicular axis if they are opposite. The lengths may be any but zero. Eigen's FromTwoVectors() has a singular
/// value decomposition for opposite directions, which takes each file that calls it 15 s to compile.
inline Eigen::Quaterniond rotationBetween(const Vec3& from, const Vec3& to)
{
    const Vec3 a = from.normalized(), sum = a + to.normalized();
    const Vec3 half = sum.norm() < 1e-8 ? a.unitOrthogonal() : sum.normalized();
    const Vec3 axis = a.cross(half);
    return Eigen::Quaterniond(a.dot(half), axis.x(), axis.y(), axis.z()).normalized();
}
} // namespace core
