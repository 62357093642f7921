#include "core/operations/plane_cut.h"

#include "core/stroke/symmetry_plane.h"

#include <cmath>

namespace core
{
namespace
{
/// Largest deviation from its mirror image at which a plane counts as its own image, as a share of the model's size.
constexpr double ownImage = 1e-5;

/// A half plane: the points whose product with the normal is at least the offset.
struct HalfPlane
{
    Eigen::Vector2d normal; ///< unit length
    double offset;
};

std::vector<Eigen::Vector2d> clipped(const std::vector<Eigen::Vector2d>& convex, const HalfPlane& half)
{
    std::vector<Eigen::Vector2d> result;
    for (std::size_t i = 0; i < convex.size(); ++i) {
        const Eigen::Vector2d &p = convex[i], &q = convex[(i + 1) % convex.size()];
        const double from = half.normal.dot(p) - half.offset, to = half.normal.dot(q) - half.offset;
        if (from >= 0)
            result.push_back(p);
        if ((from < 0) != (to < 0))
            result.emplace_back(p + from / (from - to) * (q - p));
    }
    return result;
}

/// Returns the area beyond a plane and beyond its mirror image, swept along the line where they meet. On the mirror
/// normal's side of the plane of symmetry, one of the two planes goes farther everywhere, and there its half is taken;
/// on the other side, its image. The curve goes around both halves, and between them to and fro on the same way.
ViewArea beyondBoth(const Vec3& point, const Vec3& up, const Box& whole, Symmetry symmetry)
{
    const Vec3 mirrorNormal = planeNormal(symmetry), across = mirrorNormal.cross(up);
    ViewArea area;
    area.symmetry = symmetry;
    area.direction = across.isZero(0) ? mirrorNormal.unitOrthogonal() : across.normalized();
    const Vec3 aside = area.direction.cross(mirrorNormal);
    const Vec3 center = whole.center(); // on the plane of symmetry
    const double reach = 2 * (whole.diagonal().norm() + std::abs((center - point).dot(up)));
    const HalfPlane half{{std::abs(mirrorNormal.dot(up)), aside.dot(up)}, (point - center).dot(up)};
    std::vector<Eigen::Vector2d> loop = clipped({{0, -reach}, {reach, -reach}, {reach, reach}, {0, reach}}, half);
    loop.push_back(loop.front());
    for (const Eigen::Vector2d& p : loop)
        area.outline.emplace_back(center + p.y() * aside + p.x() * mirrorNormal);
    for (std::size_t i = loop.size(); i-- > 0;)
        area.outline.push_back(mirrored(area.outline[i], symmetry));
    return area;
}
} // namespace

MirroredPlane mirroredPlane(const Vec3& point, const Vec3& normal, const Box& box, Symmetry symmetry)
{
    if (symmetry == Symmetry::None)
        return MirroredPlane::None;
    const Vec3 mirrorNormal = planeNormal(symmetry), up = normal.stableNormalized();
    if (std::abs(mirrorNormal.dot(up)) < ownImage)
        return MirroredPlane::Same;
    const bool isParallel = mirrorNormal.cross(up).norm() < ownImage;
    const bool isThere = std::abs(mirrorNormal.dot(point)) < ownImage * box.diagonal().norm();
    return isParallel && isThere ? MirroredPlane::Turned : MirroredPlane::Other;
}

/// Sweeps a rectangle along the plane. One of its sides is on the plane. A plane that is its own mirror image is placed
/// exactly so, and swept along the mirror normal.
Trim trimBeyond(const Vec3& point, const Vec3& normal, const Box& box, Symmetry symmetry)
{
    const MirroredPlane image = mirroredPlane(point, normal, box, symmetry);
    const Vec3 mirrorNormal = planeNormal(symmetry);
    Vec3 on = point, up = normal.stableNormalized();
    if (image == MirroredPlane::Same)
        up = (up - mirrorNormal.dot(up) * mirrorNormal).normalized();
    if (image == MirroredPlane::Turned) {
        on -= mirrorNormal.dot(on) * mirrorNormal;
        up = mirrorNormal.dot(up) > 0 ? mirrorNormal : Vec3(-mirrorNormal);
    }
    Trim trim;
    if (image == MirroredPlane::Other) {
        Box whole = box;
        whole.extend(mirrored(box.min(), symmetry));
        whole.extend(mirrored(box.max(), symmetry));
        trim.area = beyondBoth(on, up, whole, symmetry);
        return trim;
    }
    const bool isOwn = image == MirroredPlane::Same;
    const Vec3 along = isOwn ? mirrorNormal : up.unitOrthogonal(), aside = up.cross(along);
    const double away = (box.center() - on).dot(up);
    const double reach = 2 * (box.diagonal().norm() + std::abs(away));
    const Vec3 center = box.center() - away * up;
    trim.area.symmetry = isOwn ? symmetry : Symmetry::None;
    trim.area.direction = along;
    trim.area.outline = {center - reach * aside, center + reach * aside, center + reach * (aside + up),
                         center + reach * (up - aside)};
    return trim;
}
} // namespace core
