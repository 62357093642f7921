#pragma once

#include "vr/simulator/simulated_world.h"

#include <openxr/openxr.h>

namespace simulator
{
inline constexpr std::uint32_t largestImage = 4096; ///< pixels, either way
inline constexpr std::uint32_t maxLayers = XR_MIN_COMPOSITION_LAYERS_SUPPORTED;

/// These fail with what the specification says.
void requireSystem(XrSystemId system);
void requireViews(const SimulatedWorld& world, XrViewConfigurationType views);

/// XR_EXT_local_floor, which headers may be too old for.
inline constexpr const char* localFloorExtension = "XR_EXT_local_floor";
inline constexpr auto localFloor = static_cast<XrReferenceSpaceType>(1000426000);

std::uint32_t viewCount(XrViewConfigurationType views);
} // namespace simulator
