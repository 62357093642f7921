#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace core::io
{
/// Converts 8-bit sRGB to linear light from 0 to 1 (IEC 61966-2-1); srgbFromLinear() is the inverse. An 8-bit value
/// survives a conversion to light rounded to 16 bits and back.
inline double linearFromSrgb(std::uint8_t srgb)
{
    const double x = srgb / 255.0;
    return x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4);
}

inline std::uint8_t srgbFromLinear(double light)
{
    const double x = std::clamp(light, 0.0, 1.0);
    const double srgb = x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055;
    return static_cast<std::uint8_t>(std::lround(255 * srgb));
}
} // namespace core::io
