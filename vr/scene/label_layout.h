#pragma once

#include "vr/scene/wand_model.h"
#include "vr/util/pose.h"

#include <array>
#include <optional>

namespace vr
{
/// Where a label stands, in room space.
struct LabelPlace
{
    core::Vec3 button; ///< what it tells of
    core::Vec3 edge;   ///< the middle of the label's side that is nearest to it
    core::Vec3 center;
    core::Vec3 halfX, halfY; ///< to its right and up, as the head sees it
};

/// Width / height by WandSpot; nothing: no label.
using LabelAspects = std::array<std::optional<double>, wandSpotCount>;
using LabelPlaces = std::array<std::optional<LabelPlace>, wandSpotCount>;

/// Labels in a column on each side of a wand, all in one plane that faces the head, so that none hides another. It lies
/// before the wand, out of the clay. They grow with the distance: their letters are never less than about 1 degree
/// high.
LabelPlaces labelPlaces(const Pose& grip, const Pose& head, const LabelAspects& aspects);

/// The axes of what faces the head from somewhere: right, up, and back towards the head.
Eigen::Matrix3d axesFacing(const Pose& head, const core::Vec3& from);
} // namespace vr
