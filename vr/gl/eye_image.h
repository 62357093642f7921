#pragma once

#include <Eigen/Geometry>

#include <vector>

namespace vr
{
/// What a runtime wants filled: a GL_TEXTURE_2D of one sample and one level.
struct EyeImage
{
    unsigned int texture = 0;
    unsigned int format = 0; ///< OpenGL's sized one, GL_SRGB8_ALPHA8 or another that can be drawn into
    int width = 0, height = 0;
    unsigned int depthTexture = 0; ///< the same for depth, to be filled, too; 0: nobody wants it
    unsigned int depthFormat = 0;

    friend bool operator==(const EyeImage&, const EyeImage&) = default;
};

/// Area of a picture that no eye sees, because of the lens: triangles, three points each, in eye space at z = -1.
using HiddenArea = std::vector<Eigen::Vector2f>;

/// What one eye draws into and how.
struct EyeView
{
    unsigned int framebuffer = 0; ///< OpenGL's name, complete, with colour (sRGB or not, see isSrgb) and depth
    int width = 0, height = 0;    ///< pixels
    bool isSrgb = true;           ///< the image encodes what is written
    Eigen::Matrix4f projection = Eigen::Matrix4f::Identity(); ///< OpenGL clip space, asymmetric
    Eigen::Isometry3f view = Eigen::Isometry3f::Identity();   ///< room to eye space
    const HiddenArea* hidden = nullptr;                       ///< need not be drawn; null: nothing
};
} // namespace vr
