#pragma once

#include "vr/input/wand_mapping.h"
#include "vr/input/haptics.h"

namespace vr
{
/// The user's settings for the headset, kept from visit to visit.
struct HeadsetSettings
{
    WandSettings wands;
    double heightOffset = 0; ///< metres that the model is placed higher, at most SettingsPanel::maxHeightOffset up or down
    double turnRate = turnSpeed; ///< degrees a second
    bool showsFloor = true;
    bool showsPerformance = false;
    HapticLevels hapticLevels;

    bool operator==(const HeadsetSettings&) const = default;
};
} // namespace vr
