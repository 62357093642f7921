#pragma once

#include "vr/input/haptics.h"
#include "vr/input/wand_mapping.h"

namespace vr
{
/// The user's settings for the headset, which are kept between visits.
struct HeadsetSettings
{
    WandSettings wands;
    /// Distance by which the model is raised, metres; at most SettingsPanel::maxHeightOffset up or down.
    double heightOffset = 0;
    double turnRate = turnSpeed; ///< speed of turning the model, degrees a second
    bool showsFloor = true;
    bool hasPassthrough = false; ///< the real room is seen behind the model, if the headset can show it
    bool showsPerformance = false;
    HapticLevels hapticLevels;

    bool operator==(const HeadsetSettings&) const = default;
};
} // namespace vr
