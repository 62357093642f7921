#pragma once

#include "vr/openxr/wand_state.h"

namespace vr
{
/// One of a wand's motor; a later one of the same side takes its place.
struct HapticPulse
{
    Side side = Side::Right;
    double amplitude = 0; ///< above 0, to 1
    double frequency = 0; ///< Hz; 0: what the wand likes best
    double seconds = 0;   ///< 0: as short as the wand can
};
} // namespace vr
