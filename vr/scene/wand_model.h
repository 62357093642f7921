#pragma once

#include "vr/scene/solid_builder.h"

namespace vr
{
/// What of a wand moves or lights up.
enum class WandPart { Body, PadUp, PadDown, PadLeft, PadRight, PadMiddle, Stick, Menu, Trigger, Side, Tip };
inline constexpr std::size_t wandPartCount = 11;

/// Where a wand can be labelled.
enum class WandSpot { PadUp, PadLeft, PadDown, Trigger, Menu, PadRight, PadMiddle, Side };
inline constexpr std::size_t wandSpotCount = 8;

// A wand of our own, about as large as a Vive's: 0.24 m. In the space of the grip pose as OpenXR has it: metres, the
// palm at the origin, -Z from the hand to the tip, +Y towards the thumb, where the pad is, or a thumbstick in its
// place.

/// At rest.
core::DrawArrays wandPartModel(WandPart part);

/// On the button's surface.
core::Vec3 placeOf(WandSpot spot);

/// The middle of the bead at the front end.
core::Vec3 wandTip();

/// Where a thumb on the pad is, -1 to 1 as in WandState.
core::Vec3 placeOnPad(const Eigen::Vector2d& touch);

/// Returns the turn of the thumbstick when it is pushed, -1 to 1 as in WandState.
Eigen::Affine3d stickTurn(const Eigen::Vector2d& push);

/// Returns the turn of the trigger when it is pulled that far, 0 to 1.
Eigen::Affine3d triggerTurn(double pull);
} // namespace vr
