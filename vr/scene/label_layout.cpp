#include "vr/scene/label_layout.h"

#include <algorithm>
#include <span>

namespace vr
{
namespace
{
/// Height of a label at distances up to `readable`, metres; it is 2.4 degrees at that distance. Labels farther off are
/// larger.
constexpr double labelHeight = 0.0185;
constexpr double readable = 0.45;   ///< distance from the head up to which labels have their normal size, metres
constexpr double rowPitch = 1.24;   ///< distance from one row of labels to the next, label heights
constexpr double columnGap = 0.052; ///< distance from the wand's middle to a column, metres
/// Distance from the pad towards the head at which labels are placed, metres, so that they stay visible if the wand
/// dips into the clay. Near the eyes it is limited to a fraction of the distance to the head.
constexpr double lift = 0.1, maxLiftShare = 1.0 / 3;

// Labels of each column from top to bottom.
constexpr WandSpot leftColumn[] = {WandSpot::PadUp, WandSpot::PadLeft, WandSpot::PadDown, WandSpot::Trigger};
constexpr WandSpot rightColumn[] = {WandSpot::Menu, WandSpot::PadRight, WandSpot::PadMiddle, WandSpot::Side};

struct Column
{
    core::Vec3 origin; ///< point midway between the columns
    core::Vec3 outward, right, up;
    double gap; ///< distance from the origin to the labels, metres
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
    // Scale that keeps the apparent size that labels have at the wand.
    const double nearer = distance > 0 ? 1 - lifted / distance : 1;
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
