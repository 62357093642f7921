#pragma once

#include "vr/openxr/wand_state.h"

namespace vr
{
/// A vibration of a wand's motor. A later pulse for the same side replaces it.
struct HapticPulse
{
    Side side = Side::Right;
    double amplitude = 0; ///< strength, above 0 and at most 1
    double frequency = 0; ///< Hz; 0: the runtime's choice
    double seconds = 0;   ///< duration, seconds; 0: the shortest that the wand supports
};
} // namespace vr
