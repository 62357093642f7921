#pragma once

#include "vr/input/wand_mapping.h"
#include "vr/input/haptics.h"

namespace vr
{
/// What a person has chosen about the headset: kept from visit to visit.
struct HeadsetChoice
{
    HandsChoice hands;
    double raised = 0; ///< metres that the model is placed higher, at most SettingsPanel::mostRaised up or down
    double turnsBy = turnSpeed; ///< degrees a second
    bool showsFloor = true;
    bool showsPerformance = false;
    HapticLevels feel;

    bool operator==(const HeadsetChoice&) const = default;
};
} // namespace vr
