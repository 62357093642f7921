#pragma once

#include <Eigen/Core>

namespace vr
{
/// Values of one eye in one frame that shaders need. Room space is in metres.
struct EyeUniforms
{
    Eigen::Matrix4f view, projection; ///< room space to eye space; eye space to clip space
    Eigen::Matrix4f clip;             ///< room space to clip space
    Eigen::Vector3f eye;              ///< position of the eye in room space, metres
    Eigen::Vector3f up;               ///< up direction of the room, in eye space
    Eigen::Matrix3f lights;           ///< from the axes of the lights in clay.frag to eye space
    float pixel = 0;                  ///< width that a pixel covers at a distance of 1 m, metres
};
} // namespace vr
