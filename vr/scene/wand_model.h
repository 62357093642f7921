#pragma once

#include "vr/scene/solid_builder.h"

namespace vr
{
/// Parts of a wand that move or light up separately.
enum class WandPart { Body, PadUp, PadDown, PadLeft, PadRight, PadMiddle, Stick, Menu, Trigger, Side, Tip };
inline constexpr std::size_t wandPartCount = 11;

/// Spots of a wand that can have labels.
enum class WandSpot { PadUp, PadLeft, PadDown, Trigger, Menu, PadRight, PadMiddle, Side };
inline constexpr std::size_t wandSpotCount = 8;

// Geometry of Fettle's own wand, which is about as large as a Vive's: 0.24 m. Coordinates are in the space of OpenXR's
// grip pose: metres, the palm at the origin, -Z from the hand to the tip, +Y towards the thumb, where the pad or the
// thumbstick is.

/// Returns the mesh of a part at rest.
core::DrawArrays wandPartModel(WandPart part);

/// Returns the point on the button's surface to which a label belongs.
core::Vec3 placeOf(WandSpot spot);

/// Returns the middle of the bead at the front end.
core::Vec3 wandTip();
inline constexpr double wandTipRadius = 0.0052; ///< radius of the bead, metres

/// Returns the point of the pad that a thumb touches. `touch`: -1 to 1, as in WandState.
core::Vec3 placeOnPad(const Eigen::Vector2d& touch);

/// Returns the rotation of the thumbstick when it is pushed. `push`: -1 to 1, as in WandState.
Eigen::Affine3d stickTurn(const Eigen::Vector2d& push);

/// Returns the rotation of the trigger when it is pulled by a fraction of 0 to 1.
Eigen::Affine3d triggerTurn(double pull);
} // namespace vr
