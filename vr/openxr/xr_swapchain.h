#pragma once

#include "vr/openxr/xr_handle.h"

#include <cstdint>
#include <span>
#include <vector>

namespace vr
{
/// Pixel format of the images of a swapchain.
struct ImageFormat
{
    std::int64_t name = 0; ///< sized OpenGL format, such as GL_SRGB8_ALPHA8
    /// OpenGL encodes the colours written while GL_FRAMEBUFFER_SRGB is enabled. If false, the image stores linear light
    /// unchanged.
    bool isSrgb = false;
    bool isDepth = false;

    friend bool operator==(const ImageFormat&, const ImageFormat&) = default;
};

/// Returns the offered colour formats that Fettle can draw into, the best first.
std::vector<ImageFormat> usableFormats(std::span<const std::int64_t> offered);
/// Returns the offered depth formats that Fettle can draw into, the best first.
std::vector<ImageFormat> usableDepthFormats(std::span<const std::int64_t> offered);

struct ImageSize
{
    int width = 0, height = 0; ///< pixels
};

/// The images that one eye is shown in turn: GL_TEXTURE_2D, one sample per pixel, one mip level. Precondition: the
/// session's context is current. The constructor, acquire() and release() throw XrError.
class Swapchain
{
public:
    Swapchain(XrSession session, const ImageFormat& format, const ImageSize& size);

    /// Returns the texture of the next image, after the runtime has finished reading it. Precondition: no other image
    /// of this swapchain is acquired.
    unsigned int acquire();
    /// Gives the acquired image back. Its content is shown with the frame that ends next.
    void release();

    XrSwapchain handle() const { return m_handle.get(); }
    const ImageSize& size() const { return m_size; }

private:
    ImageSize m_size;
    SwapchainHandle m_handle;
    std::vector<unsigned int> m_textures;
};
} // namespace vr
