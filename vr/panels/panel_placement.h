#pragma once

#include "vr/openxr/wand_state.h"
#include "vr/panels/panel_action.h"
#include "vr/util/pose.h"

#include <Eigen/Core>

#include <optional>

namespace vr
{
// Where panels stand in the room. A panel's pose is that of its middle: +X to its right, +Y up, +Z towards who reads
// it. All pure.

struct HandPanelPlacement
{
    Eigen::Vector2d size{0.5, 0.4}; ///< metres
    /// Of the room: it goes aside until it is out of that, and out of what that hides. Where that is too far it stays
    /// at the hand.
    std::optional<core::Sphere> clear{};
    double asideSign = 1; ///< 1: aside is to the left, -1: to the right
};

/// Above a hand and before it, facing the head; it goes with the hand. Of a hand that hangs low it comes nearer to the
/// eyes, where it can be read.
Pose placeAtHand(const Pose& grip, const Pose& head, const HandPanelPlacement& place);

struct AheadPanelPlacement
{
    Eigen::Vector2d size{0.5, 0.4}; ///< metres
    double distance = 0.6;          ///< metres from the head to its middle
    double aside = 0;               ///< radians, to the left of where the head looks
    double below = 0.05;            ///< metres, its middle below the eyes
    /// Obstacles of the room: a panel keeps out of that, and out of what that hides. Where it would not, it stands as
    /// near to where the head looks as it can, on either side.
    std::optional<core::Sphere> clear{};
};

/// Upright, ahead of the head or aside, turned to it about the vertical. It is placed once, and does not follow the
/// head.
Pose placeAhead(const Pose& head, const AheadPanelPlacement& place);

/// Whether somebody has walked away from a panel that was placed ahead: it may be placed anew.
bool isOutOfReach(const Pose& panel, const Pose& head);

/// A panel at which a wand may point.
struct PanelTarget
{
    Pose pose;
    Eigen::Vector2d size;        ///< metres
    std::optional<Side> carrier; ///< the hand with which it goes; that one does not point at it
    PanelKind kind = PanelKind::Tools;
};

/// Returns whether one hides a part of the other from the head, or nearly.
bool overlapInSight(const PanelTarget& a, const PanelTarget& b, const Pose& head);

/// Where a ray meets a panel's plane.
struct PlanePoint
{
    Eigen::Vector2d at; ///< metres from the panel's middle, x to the right, y up
    double distance;    ///< metres along the ray
};
/// Nothing if it comes from behind, or leads away.
std::optional<PlanePoint> intersect(const core::Ray& ray, const Pose& panel);
} // namespace vr
