#pragma once

#include "vr/input/haptics.h"
#include "vr/input/wand_mapping.h"

namespace vr
{
/// The user's settings for the headset, kept from visit to visit.
struct HeadsetSettings
{
    WandSettings wands;
    /// Metres that the model is placed higher, at most SettingsPanel::maxHeightOffset up or down.
    double heightOffset = 0;
    double turnRate = turnSpeed; ///< degrees a second
    bool showsFloor = true;
    bool showsPerformance = false;
    HapticLevels hapticLevels;

    bool operator==(const HeadsetSettings&) const = default;
};
} // namespace vr
