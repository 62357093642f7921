#include "vr/panels/panel_placement.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vr
{
namespace
{
using core::Vec3;

constexpr double handReach = 0.07; ///< metres from the palm along the wand to the point above which the panel is
constexpr double handClear = 0.06; ///< gap between the wand and the panel's lower edge, metres
constexpr double farthestAtHand =
    0.65; ///< largest distance from the eyes, metres: letters are readable there, however low the hand is
constexpr double farthestReach = 1.3; ///< distance from the head at which a panel is out of reach, metres
constexpr double asideStep = 5 * std::numbers::pi / 180, maxAside = 110 * std::numbers::pi / 180;
constexpr double maxAsideOfHand = 60 * std::numbers::pi / 180;
constexpr int halvings = 16; ///< steps of the bisection from 0 to maxAsideOfHand: exact to 0.01 mm at arm's length
constexpr double nothing = 1e-9;

/// Returns the pose of a panel that faces the head, as upright as possible. A panel seen from straight above is turned
/// as the head is.
Pose facing(const Vec3& middle, const Pose& head)
{
    const Vec3 z = (head.position - middle).normalized();
    const double steepness = std::abs(z.y());
    const Vec3 up = (1 - steepness) * Vec3::UnitY() + steepness * (head.rotation * Vec3::UnitY());
    Vec3 x = up.cross(z);
    if (x.norm() < nothing)
        x = head.rotation * Vec3::UnitX();
    x = (x - x.dot(z) * z).normalized();
    Eigen::Matrix3d axes;
    axes << x, z.cross(x), z;
    return {Eigen::Quaterniond(axes), middle};
}

/// Returns the horizontal direction in which the head looks. If it looks straight up or down, the direction of its chin
/// or of its top is used.
Vec3 heading(const Pose& head)
{
    const Vec3 forward = head.forward(), top = head.rotation * Vec3::UnitY();
    const Vec3 wanted = std::abs(forward.y()) < 0.9 ? forward : forward.y() > 0 ? Vec3(-top) : top;
    const Vec3 flat(wanted.x(), 0, wanted.z());
    return flat.norm() < nothing ? Vec3(-Vec3::UnitZ()) : flat.normalized();
}

Pose ahead(const Pose& head, const AheadPanelPlacement& place, double aside)
{
    const Eigen::AngleAxisd turn(aside, Vec3::UnitY());
    const Vec3 direction = turn * heading(head);
    const Vec3 middle = head.position + place.distance * direction - place.below * Vec3::UnitY();
    Eigen::Matrix3d axes;
    axes << Vec3::UnitY().cross(-direction), Vec3::UnitY(), -direction;
    return {Eigen::Quaterniond(axes), middle};
}

double distanceToSegment(const Vec3& point, const Vec3& from, const Vec3& to)
{
    const Vec3 along = to - from;
    const double t = std::clamp((point - from).dot(along) / along.squaredNorm(), 0.0, 1.0);
    return (from + t * along - point).norm();
}

/// Returns whether the panel is outside the sphere and not hidden by it. Tests its corners, the middles of its sides
/// and its middle.
bool isClear(const Pose& panel, const Pose& head, const Eigen::Vector2d& size, const core::Sphere& clear)
{
    for (const double x : {-0.5, 0.0, 0.5})
        for (const double y : {-0.5, 0.0, 0.5}) {
            const Vec3 point = panel * Vec3(x * size.x(), y * size.y(), 0);
            if (distanceToSegment(clear.center, head.position, point) < clear.radius)
                return false;
        }
    return true;
}

/// Returns the least turn from 0 to max (radians) that is enough, by bisection; 0 if max is not enough.
template <class IsEnough> double minTurn(double max, const IsEnough& isEnough)
{
    if (isEnough(0) || !isEnough(max))
        return 0;
    double less = 0, enough = max;
    for (int i = 0; i < halvings; ++i) {
        const double middle = (less + enough) / 2;
        (isEnough(middle) ? enough : less) = middle;
    }
    return enough;
}
} // namespace

Pose placeAtHand(const Pose& grip, const Pose& head, const HandPanelPlacement& place)
{
    const Vec3 foot = grip * Vec3(0, 0, -handReach);
    const Vec3 up = facing(foot, head).rotation * Vec3::UnitY();
    const Vec3 middle = foot + (handClear + place.size.y() / 2) * up, way = middle - head.position;
    const Vec3 toPanel = std::min(1.0, farthestAtHand / way.norm()) * way;
    const auto turned = [&](double aside) {
        return facing(head.position + Eigen::AngleAxisd(place.asideSign * aside, Vec3::UnitY()) * toPanel, head);
    };
    if (!place.clear)
        return turned(0);
    return turned(
        minTurn(maxAsideOfHand, [&](double aside) { return isClear(turned(aside), head, place.size, *place.clear); }));
}

Pose placeAhead(const Pose& head, const AheadPanelPlacement& place)
{
    const auto clearAt = [&](double aside) -> std::optional<Pose> {
        const Pose pose = ahead(head, place, aside);
        return !place.clear || isClear(pose, head, place.size, *place.clear) ? std::optional(pose) : std::nullopt;
    };
    if (const std::optional<Pose> wanted = clearAt(place.aside))
        return *wanted;
    const double preferred = place.aside < 0 ? -1 : 1;
    for (double away = 0; away <= maxAside; away += asideStep)
        for (const double sign : {preferred, -preferred})
            if (const std::optional<Pose> pose = clearAt(sign * away))
                return *pose;
    return ahead(head, place, place.aside);
}

bool overlapInSight(const PanelTarget& a, const PanelTarget& b, const Pose& head)
{
    const auto boundsOf = [&head](const PanelTarget& panel) {
        Eigen::AlignedBox2d bounds; // radians to the right and up
        for (const double x : {-0.5, 0.5})
            for (const double y : {-0.5, 0.5}) {
                const Vec3 own = head.inverse() * (panel.pose * Vec3(x * panel.size.x(), y * panel.size.y(), 0));
                bounds.extend(
                    Eigen::Vector2d(std::atan2(own.x(), -own.z()), std::atan2(own.y(), std::hypot(own.x(), own.z()))));
            }
        return bounds;
    };
    return !boundsOf(a).intersection(boundsOf(b)).isEmpty();
}

bool isOutOfReach(const Pose& panel, const Pose& head)
{
    return (panel.position - head.position).norm() > farthestReach;
}

std::optional<PlanePoint> intersect(const core::Ray& ray, const Pose& panel)
{
    const Pose toPanel = panel.inverse();
    const Vec3 from = toPanel * ray.origin, direction = toPanel.rotation * ray.direction.normalized();
    if (from.z() <= 0 || direction.z() > -nothing)
        return std::nullopt;
    const double distance = -from.z() / direction.z();
    const Vec3 at = from + distance * direction;
    return PlanePoint{at.head<2>(), distance};
}
} // namespace vr
