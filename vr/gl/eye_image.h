#pragma once

#include <Eigen/Geometry>

#include <vector>

namespace vr
{
/// The textures that the runtime wants filled for one eye: GL_TEXTURE_2D, one sample per pixel, one mip level.
struct EyeImage
{
    unsigned int texture = 0;
    unsigned int format = 0; ///< sized OpenGL format of `texture`, such as GL_SRGB8_ALPHA8; it can be rendered to
    int width = 0, height = 0;
    unsigned int depthTexture = 0; ///< depth texture of the same size, to be filled too; 0: the runtime wants no depth
    unsigned int depthFormat = 0;

    friend bool operator==(const EyeImage&, const EyeImage&) = default;
};

/// The part of one eye's picture that the lens hides: triangles of three points each, in eye space on the plane z = -1.
using HiddenArea = std::vector<Eigen::Vector2f>;

/// The framebuffer, the projection and the view of one eye.
struct EyeView
{
    unsigned int framebuffer = 0; ///< name of a complete OpenGL framebuffer with colour and depth; 0: not set yet
    int width = 0, height = 0;    ///< pixels
    bool isSrgb = true;           ///< the framebuffer is sRGB: OpenGL encodes the linear colours that are written
    Eigen::Matrix4f projection = Eigen::Matrix4f::Identity(); ///< eye space to OpenGL clip space; asymmetric
    Eigen::Isometry3f view = Eigen::Isometry3f::Identity();   ///< room space to eye space
    /// The real room is seen where nothing is drawn: there the picture is black with the alpha value 0.
    bool hasPassthrough = false;
    /// Area that the lens hides, which need not be drawn; null: none.
    const HiddenArea* hidden = nullptr;
};
} // namespace vr
