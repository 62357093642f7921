#pragma once

#include "vr/openxr/xr_handle.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace vr
{
/// What an image of a swapchain is made of.
struct ImageFormat
{
    std::int64_t name = 0; ///< OpenGL's
    /// OpenGL encodes what is written where GL_FRAMEBUFFER_SRGB is on; else the image holds linear light as written.
    bool isSrgb = false;
    bool isDepth = false;

    friend bool operator==(const ImageFormat&, const ImageFormat&) = default;
};

/// The best of those that are offered; none if we could draw into none of them.
std::optional<ImageFormat> bestFormat(std::span<const std::int64_t> offered);
/// Returns the best of the formats for depth that are offered, in the same way.
std::optional<ImageFormat> bestDepthFormat(std::span<const std::int64_t> offered);

struct ImageSize
{
    int width = 0, height = 0; ///< pixels
};

/// The images that one eye is shown by turns: GL_TEXTURE_2D, one sample, one level. Members throw XrError. The
/// session's context is current.
class Swapchain
{
public:
    Swapchain(XrSession session, const ImageFormat& format, const ImageSize& size);

    /// Of the next image, once the runtime is done with it. One at a time.
    unsigned int acquire();
    /// What is in it is shown with the frame that ends next.
    void release();

    XrSwapchain handle() const { return m_handle.get(); }
    const ImageSize& size() const { return m_size; }

private:
    ImageSize m_size;
    SwapchainHandle m_handle;
    std::vector<unsigned int> m_textures;
};
} // namespace vr
