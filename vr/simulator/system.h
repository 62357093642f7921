#pragma once

#include "vr/simulator/simulated_world.h"

#include <openxr/openxr.h>

namespace simulator
{
inline constexpr std::uint32_t largestImage = 4096; ///< largest width and largest height of an image, pixels
inline constexpr std::uint32_t maxLayers = XR_MIN_COMPOSITION_LAYERS_SUPPORTED;

/// Checks that fail with the result that the specification demands.
void requireSystem(XrSystemId system);
void requireViews(const SimulatedWorld& world, XrViewConfigurationType views);

/// Name and value that XR_EXT_local_floor defines and older OpenXR headers lack.
inline constexpr const char* localFloorExtension = "XR_EXT_local_floor";
inline constexpr auto localFloor = static_cast<XrReferenceSpaceType>(1000426000);

std::uint32_t viewCount(XrViewConfigurationType views);
} // namespace simulator
