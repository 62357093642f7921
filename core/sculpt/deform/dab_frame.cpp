#include "core/sculpt/deform/dab_frame.h"

#include "core/sculpt/deform/deform.h"

namespace core
{
namespace
{
/// A direction is used for up only if the squared sine of its angle to the normal is larger. Otherwise its projection
/// onto the plane would be too short to be reliable.
constexpr double minUpright2 = 0.01;

Vec3 alongPlane(const Vec3& v, const Vec3& normal)
{
    return v - v.dot(normal) * normal;
}

DabFrame frameOf(const Vec3& normal, const Vec3& way, bool isMirrored)
{
    const Vec3 up = way / way.norm();
    const Vec3 right = up.cross(normal);
    return {isMirrored ? Vec3(-right) : right, up, normal};
}
} // namespace

DabFrame frameOn(const Region& region, const Mesh& mesh, const StrokeSettings& settings, const Dab& dab)
{
    const Vec3 normal = dab.normal.isZero(0) ? meanNormal(region, mesh) : dab.normal;
    if (normal.isZero(0))
        return {};
    const Vec3 way = settings.alphaFollows ? alongPlane(dab.motion, normal) : Vec3(Vec3::Zero());
    const Vec3 up = alongPlane(dab.up, normal);
    if (way.squaredNorm() > minUpright2 * dab.motion.squaredNorm())
        return frameOf(normal, way, dab.isMirrored);
    return frameOf(normal, up.squaredNorm() > minUpright2 ? up : alongPlane(dab.ahead, normal), dab.isMirrored);
}

DabFrame uprightFrame(const Dab& dab)
{
    return frameOf(dab.up, dab.ahead, dab.isMirrored);
}
} // namespace core
