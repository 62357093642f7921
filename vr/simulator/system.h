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

std::uint32_t viewCount(XrViewConfigurationType views);
} // namespace simulator
