#pragma once

#include "core/geometry.h"
#include "core/mesh_io/srgb.h"

namespace vr
{
/// What of a colour a shader adds and mixes.
inline Eigen::Vector3f lightOf(const core::Rgb& color)
{
    using core::mesh_io::lightOf;
    return core::Vec3(lightOf(color.r), lightOf(color.g), lightOf(color.b)).cast<float>();
}
} // namespace vr
