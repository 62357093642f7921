#include "vr/openxr/xr_swapchain.h"

#include "vr/openxr/xr_result.h"

#include <qopengl.h>

#define XR_USE_GRAPHICS_API_OPENGL
#include <openxr/openxr_platform.h>

#include <algorithm>

namespace vr
{
namespace
{
/// Colour formats, the best first. OpenXR reads formats without sRGB as linear light. GL_RGBA8 is the last, because
/// linear light in eight bits shows bands in the dark.
constexpr ImageFormat formats[] = {
    {GL_SRGB8_ALPHA8, true}, {GL_RGBA16F, false}, {GL_RGB10_A2, false}, {GL_RGBA8, false}};

/// Depth formats, the best first. Formats of sixteen bits are left out: they resolve the clay's surface only to
/// millimetres.
constexpr ImageFormat depthFormats[] = {{GL_DEPTH_COMPONENT24, false, true}, {GL_DEPTH_COMPONENT32F, false, true}};

std::vector<ImageFormat> allOffered(std::span<const ImageFormat> wanted, std::span<const std::int64_t> offered)
{
    std::vector<ImageFormat> found;
    std::ranges::copy_if(wanted, std::back_inserter(found), [&](const ImageFormat& format) {
        return std::ranges::find(offered, format.name) != offered.end();
    });
    return found;
}

SwapchainHandle makeSwapchain(XrSession session, const ImageFormat& format, const ImageSize& size)
{
    XrSwapchainCreateInfo info{};
    info.type = XR_TYPE_SWAPCHAIN_CREATE_INFO;
    info.usageFlags = XR_SWAPCHAIN_USAGE_SAMPLED_BIT | (format.isDepth ? XR_SWAPCHAIN_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT
                                                                       : XR_SWAPCHAIN_USAGE_COLOR_ATTACHMENT_BIT);
    info.format = format.name;
    info.sampleCount = 1;
    info.width = static_cast<std::uint32_t>(size.width);
    info.height = static_cast<std::uint32_t>(size.height);
    info.faceCount = 1;
    info.arraySize = 1;
    info.mipCount = 1;
    XrSwapchain made = XR_NULL_HANDLE;
    check(xrCreateSwapchain(session, &info, &made), "xrCreateSwapchain");
    return SwapchainHandle(made);
}
} // namespace

std::vector<ImageFormat> usableFormats(std::span<const std::int64_t> offered)
{
    return allOffered(formats, offered);
}

std::vector<ImageFormat> usableDepthFormats(std::span<const std::int64_t> offered)
{
    return allOffered(depthFormats, offered);
}

Swapchain::Swapchain(XrSession session, const ImageFormat& format, const ImageSize& size)
    : m_size(size)
    , m_handle(makeSwapchain(session, format, size))
{
    const auto images = enumerate(
        "xrEnumerateSwapchainImages", XrSwapchainImageOpenGLKHR{XR_TYPE_SWAPCHAIN_IMAGE_OPENGL_KHR, nullptr, 0},
        [&](auto capacity, auto* count, auto* items) {
            return xrEnumerateSwapchainImages(handle(), capacity, count,
                                              reinterpret_cast<XrSwapchainImageBaseHeader*>(items));
        });
    for (const XrSwapchainImageOpenGLKHR& image : images)
        m_textures.push_back(image.image);
}

unsigned int Swapchain::acquire()
{
    std::uint32_t index = 0;
    check(xrAcquireSwapchainImage(handle(), nullptr, &index), "xrAcquireSwapchainImage");
    const XrSwapchainImageWaitInfo info{XR_TYPE_SWAPCHAIN_IMAGE_WAIT_INFO, nullptr, XR_INFINITE_DURATION};
    check(xrWaitSwapchainImage(handle(), &info), "xrWaitSwapchainImage");
    return m_textures.at(index);
}

void Swapchain::release()
{
    check(xrReleaseSwapchainImage(handle(), nullptr), "xrReleaseSwapchainImage");
}
} // namespace vr
