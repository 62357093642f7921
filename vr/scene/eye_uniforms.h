#pragma once

#include <Eigen/Core>

namespace vr
{
/// What shaders must know of one eye in one frame. Room space is in metres.
struct EyeUniforms
{
    Eigen::Matrix4f view, projection; ///< room to eye space, and on to clip space
    Eigen::Matrix4f clip;             ///< room to clip space
    Eigen::Vector3f eye;              ///< its place in the room
    Eigen::Vector3f up;               ///< the room's, in eye space
    Eigen::Matrix3f lights;           ///< from the axes of clay.frag's lights to eye space
    float pixel = 0;                  ///< what a pixel covers at a distance of 1 m, metres
};
} // namespace vr
