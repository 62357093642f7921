#pragma once

#include "vr/scene/wand_model.h"
#include "vr/util/pose.h"

#include <array>
#include <optional>

namespace vr
{
/// Position and size of a label in room space, metres.
struct LabelPlace
{
    core::Vec3 button; ///< the button that the label describes
    core::Vec3 edge;   ///< middle of the label's edge that is nearest to the wand
    core::Vec3 center;
    core::Vec3 halfX, halfY; ///< half extents to the right and upward, as the head sees the label
};

/// Width / height of each label, indexed by WandSpot; none: no label.
using LabelAspects = std::array<std::optional<double>, wandSpotCount>;
using LabelPlaces = std::array<std::optional<LabelPlace>, wandSpotCount>;

/// Returns the places of labels in a column on each side of a wand. All labels are in one plane that faces the head, so
/// that none hides another. The plane is in front of the wand, so that it is not in the clay. Labels grow with the
/// distance: their letters are never less than about 1 degree high.
LabelPlaces labelPlaces(const Pose& grip, const Pose& head, const LabelAspects& aspects);

/// Returns the axes of an object at `from` that faces the head: right, up, and back towards the head.
Eigen::Matrix3d axesFacing(const Pose& head, const core::Vec3& from);
} // namespace vr
