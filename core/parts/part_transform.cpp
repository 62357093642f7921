#include "core/parts/part_transform.h"

namespace core
{
Vec3 Transform::placeOf(const Vec3& p, double freedom) const
{
    const Vec3 stretch = freedom * (scale - Vec3::Ones()) + Vec3::Ones();
    const Vec3 stretched = scaleAxes * stretch.cwiseProduct(scaleAxes.conjugate() * (p - centre));
    const Eigen::Quaterniond turn = freedom == 1 ? rotation : Eigen::Quaterniond::Identity().slerp(freedom, rotation);
    return centre + freedom * by + turn * stretched;
}

bool Transform::isNothing() const
{
    return by.isZero(0) && rotation == Eigen::Quaterniond::Identity() && scale == Vec3::Ones();
}
} // namespace core
