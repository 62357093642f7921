#pragma once

#include "vr/openxr/wand_state.h"

namespace vr
{
/// A pulse of a wand's motor. A later pulse of the same side replaces it.
struct HapticPulse
{
    Side side = Side::Right;
    double amplitude = 0; ///< above 0, to 1
    double frequency = 0; ///< Hz; 0: the runtime's choice
    double seconds = 0;   ///< 0: the shortest that the wand can do
};
} // namespace vr
