#pragma once

#include "core/geometry/geometry.h"
#include "core/io/mesh/srgb.h"

namespace vr
{
/// Returns an sRGB colour as linear light, in which shaders add and mix colours.
inline Eigen::Vector3f linearFromSrgb(const core::Rgb& color)
{
    using core::io::linearFromSrgb;
    return core::Vec3(linearFromSrgb(color.r), linearFromSrgb(color.g), linearFromSrgb(color.b)).cast<float>();
}
} // namespace vr
