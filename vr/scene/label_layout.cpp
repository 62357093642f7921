#include "vr/scene/label_layout.h"

#include <algorithm>
#include <span>

namespace vr
{
namespace
{
/// Metres, up to `readable` away; farther off the labels grow. A plate of 2.4 degrees.
constexpr double labelHeight = 0.0185;
constexpr double readable = 0.45;   ///< metres
constexpr double rowPitch = 1.24;   ///< label heights
constexpr double columnGap = 0.052; ///< metres from the wand's middle
/// Metres from the pad towards the head: a wand that dips into the clay does not take its labels along. Near the eyes
/// it is less: a share of the way.
constexpr double lift = 0.1, maxLiftShare = 1.0 / 3;

// From top to bottom.
constexpr WandSpot leftColumn[] = {WandSpot::PadUp, WandSpot::PadLeft, WandSpot::PadDown, WandSpot::Trigger};
constexpr WandSpot rightColumn[] = {WandSpot::Menu, WandSpot::PadRight, WandSpot::PadMiddle, WandSpot::Side};

struct Column
{
    core::Vec3 origin; ///< the middle between the columns
    core::Vec3 outward, right, up;
    double gap; ///< metres
    double scale;
};

void place(const Column& column, std::span<const WandSpot> spots, const Pose& grip, const LabelAspects& aspects,
           LabelPlaces& into)
{
    const auto isThere = [&](WandSpot spot) { return aspects[static_cast<std::size_t>(spot)].has_value(); };
    const auto rows = static_cast<double>(std::ranges::count_if(spots, isThere));
    const double height = labelHeight * column.scale;
    double row = (rows - 1) / 2;
    for (const WandSpot spot : spots) {
        if (!isThere(spot))
            continue;
        const double width = height * *aspects[static_cast<std::size_t>(spot)];
        const core::Vec3 edge = column.origin + column.gap * column.outward + row * rowPitch * height * column.up;
        into[static_cast<std::size_t>(spot)] = LabelPlace{grip * placeOf(spot), edge, edge + width / 2 * column.outward,
                                                          width / 2 * column.right, height / 2 * column.up};
        --row;
    }
}
} // namespace

Eigen::Matrix3d axesFacing(const Pose& head, const core::Vec3& from)
{
    const core::Vec3 away = head.position - from;
    const core::Vec3 back =
        away.isZero() ? core::Vec3(head.rotation * core::Vec3::UnitZ()) : core::Vec3(away.normalized());
    const core::Vec3 sideways = head.rotation * core::Vec3::UnitX();
    const core::Vec3 right = (sideways - back * back.dot(sideways)).normalized();
    Eigen::Matrix3d axes;
    axes << right, back.cross(right), back;
    return axes;
}

LabelPlaces labelPlaces(const Pose& grip, const Pose& head, const LabelAspects& aspects)
{
    const core::Vec3 middle = grip * placeOf(WandSpot::PadMiddle);
    const Eigen::Matrix3d axes = axesFacing(head, middle);
    const double distance = (head.position - middle).norm(), lifted = std::min(lift, maxLiftShare * distance);
    const double nearer = distance > 0 ? 1 - lifted / distance : 1; // as large for the eye as at the wand
    Column column{middle + lifted * axes.col(2),
                  -axes.col(0),
                  axes.col(0),
                  axes.col(1),
                  nearer * columnGap,
                  nearer * std::max(1.0, distance / readable)};
    LabelPlaces places;
    place(column, leftColumn, grip, aspects, places);
    column.outward = column.right;
    place(column, rightColumn, grip, aspects, places);
    return places;
}
} // namespace vr
