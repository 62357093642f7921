#pragma once

#include "vr/openxr/wand_state.h"
#include "vr/panels/panel_action.h"
#include "vr/util/pose.h"

#include <Eigen/Core>

#include <optional>

namespace vr
{
// Functions that place panels in the room. A panel's pose is that of its middle: +X to its right, +Y up, +Z towards the
// reader.

struct HandPanelPlacement
{
    Eigen::Vector2d size{0.5, 0.4}; ///< metres
    /// Obstacle in room space. The panel moves aside until it is outside the obstacle and not hidden by it. If no turn
    /// up to 60 degrees is enough, the panel stays at the hand.
    std::optional<core::Sphere> clear{};
    double asideSign = 1; ///< 1: aside is to the left, -1: to the right
};

/// Returns the pose of a panel above and in front of a hand, facing the head. If the hand is low, the panel is nearer
/// to the eyes, so that it can be read.
Pose placeAtHand(const Pose& grip, const Pose& head, const HandPanelPlacement& place);

struct AheadPanelPlacement
{
    Eigen::Vector2d size{0.5, 0.4}; ///< metres
    double distance = 0.6;          ///< distance from the head to the panel's middle, metres
    double aside = 0;               ///< angle to the left of where the head looks, radians
    double below = 0.05;            ///< distance of the panel's middle below the eyes, metres
    /// Obstacle in room space. The panel must be outside the obstacle and not hidden by it. If it would not be, it is
    /// placed as near to where the head looks as possible, up to 110 degrees to either side, or else at `aside`.
    std::optional<core::Sphere> clear{};
};

/// Returns the pose of an upright panel ahead of the head or to its side, turned to the head about the vertical. The
/// panel is placed once, and does not follow the head.
Pose placeAhead(const Pose& head, const AheadPanelPlacement& place);

/// Returns whether the user has walked away from a panel that was placed ahead, so that it may be placed again.
bool isOutOfReach(const Pose& panel, const Pose& head);

/// A panel at which a wand may point.
struct PanelTarget
{
    Pose pose;
    Eigen::Vector2d size;        ///< metres
    std::optional<Side> carrier; ///< hand that carries the panel and does not point at it; none: no hand does
    PanelKind kind = PanelKind::Tools;
};

/// Returns whether one panel hides a part of the other from the head, or nearly does.
bool overlapInSight(const PanelTarget& a, const PanelTarget& b, const Pose& head);

/// The point where a ray meets a panel's plane.
struct PlanePoint
{
    Eigen::Vector2d at; ///< metres from the panel's middle, x to the right, y up
    double distance;    ///< metres along the ray
};
/// Returns where the ray meets the panel's plane; none if the ray comes from behind or leads away.
std::optional<PlanePoint> intersect(const core::Ray& ray, const Pose& panel);
} // namespace vr
