#include "vr/simulator/calls.h"
#include "vr/simulator/swapchain.h"
#include "vr/simulator/system.h"

namespace simulator
{
namespace
{
constexpr XrSwapchainUsageFlags knownUsages = 0xFF;
constexpr XrSwapchainCreateFlags knownFlags =
    XR_SWAPCHAIN_CREATE_PROTECTED_CONTENT_BIT | XR_SWAPCHAIN_CREATE_STATIC_IMAGE_BIT;

bool isOffered(std::int64_t format)
{
    const auto& formats = ShareContext::formats();
    return std::find(formats.begin(), formats.end(), format) != formats.end();
}

TextureForm checkedForm(const XrSwapchainCreateInfo& info)
{
    require((info.createFlags & ~knownFlags) == 0 && (info.usageFlags & ~knownUsages) == 0, XR_ERROR_VALIDATION_FAILURE,
            "unknown flags");
    require((info.createFlags & XR_SWAPCHAIN_CREATE_PROTECTED_CONTENT_BIT) == 0, XR_ERROR_FEATURE_UNSUPPORTED,
            "no protected content");
    require(isOffered(info.format), XR_ERROR_SWAPCHAIN_FORMAT_UNSUPPORTED, "the format is not offered");
    require(info.width > 0 && info.height > 0 && info.width <= largestImage && info.height <= largestImage,
            XR_ERROR_VALIDATION_FAILURE, "too large, or empty");
    require(info.faceCount == 1 || info.faceCount == 6, XR_ERROR_VALIDATION_FAILURE, "an image has one face or six");
    require(info.faceCount == 1 && info.sampleCount == 1, XR_ERROR_FEATURE_UNSUPPORTED, "no cubes, one sample");
    require(info.arraySize > 0 && info.mipCount > 0, XR_ERROR_VALIDATION_FAILURE, "no layer, or no level");
    return {info.format, static_cast<int>(info.width), static_cast<int>(info.height), static_cast<int>(info.arraySize),
            static_cast<int>(info.mipCount)};
}

Session& sessionOf(const Swapchain& swapchain)
{
    return static_cast<Session&>(*swapchain.parent);
}
} // namespace

XrResult enumerateSwapchainFormats(Call& call, XrSession handle, std::uint32_t capacity, std::uint32_t* count,
                                   std::int64_t* formats)
{
    call.get<Session>(handle);
    writeItems(OutputArray<std::int64_t>{capacity, count, formats}, ShareContext::formats());
    return XR_SUCCESS;
}

XrResult createSwapchain(Call& call, XrSession handle, const XrSwapchainCreateInfo* info, XrSwapchain* out)
{
    Session& session = call.get<Session>(handle);
    validated(info, XR_TYPE_SWAPCHAIN_CREATE_INFO);
    validated(out);
    call.checkContext(session);
    const TextureForm form = checkedForm(*info);
    require(!call.runtime.world.failingFormats.contains(form.format), XR_ERROR_RUNTIME_FAILURE, "so the script says");
    const bool isStatic = (info->createFlags & XR_SWAPCHAIN_CREATE_STATIC_IMAGE_BIT) != 0;
    *out = call.runtime.handles.add<XrSwapchain>(std::make_shared<Swapchain>(session.gl(), form, isStatic), &session);
    call.line.update({{"format", form.format}, {"size", {form.width, form.height}}, {"layers", form.layers}});
    return XR_SUCCESS;
}

XrResult destroySwapchain(Call& call, XrSwapchain handle)
{
    const auto swapchain = call.runtime.handles.find<Swapchain>(handle);
    call.checkContext(sessionOf(*swapchain));
    if (!swapchain->isDrawn())
        call.error("its images are still drawn on");
    call.runtime.handles.destroy(*swapchain);
    return XR_SUCCESS;
}

XrResult enumerateSwapchainImages(Call& call, XrSwapchain handle, std::uint32_t capacity, std::uint32_t* count,
                                  XrSwapchainImageBaseHeader* images)
{
    const auto& swapchain = call.get<Swapchain>(handle);
    call.checkContext(sessionOf(swapchain));
    writeItems(
        OutputArray<XrSwapchainImageOpenGLKHR>{capacity, count, reinterpret_cast<XrSwapchainImageOpenGLKHR*>(images)},
        swapchain.textures(), [](XrSwapchainImageOpenGLKHR& to, unsigned int texture) {
            validated(&to, XR_TYPE_SWAPCHAIN_IMAGE_OPENGL_KHR).image = texture;
        });
    return XR_SUCCESS;
}

XrResult acquireSwapchainImage(Call& call, XrSwapchain handle, const XrSwapchainImageAcquireInfo* info,
                               std::uint32_t* index)
{
    auto& swapchain = call.get<Swapchain>(handle);
    if (info)
        validated(info, XR_TYPE_SWAPCHAIN_IMAGE_ACQUIRE_INFO);
    call.checkContext(sessionOf(swapchain));
    validated(index) = static_cast<std::uint32_t>(swapchain.acquire());
    call.line["image"] = *index;
    return XR_SUCCESS;
}

XrResult waitSwapchainImage(Call& call, XrSwapchain handle, const XrSwapchainImageWaitInfo* info)
{
    auto& swapchain = call.get<Swapchain>(handle);
    validated(info, XR_TYPE_SWAPCHAIN_IMAGE_WAIT_INFO);
    call.checkContext(sessionOf(swapchain));
    swapchain.wait();
    return XR_SUCCESS;
}

XrResult releaseSwapchainImage(Call& call, XrSwapchain handle, const XrSwapchainImageReleaseInfo* info)
{
    auto& swapchain = call.get<Swapchain>(handle);
    if (info)
        validated(info, XR_TYPE_SWAPCHAIN_IMAGE_RELEASE_INFO);
    call.checkContext(sessionOf(swapchain));
    swapchain.release();
    if (call.runtime.world.watchesDrawing)
        swapchain.markDrawing();
    return XR_SUCCESS;
}
} // namespace simulator
