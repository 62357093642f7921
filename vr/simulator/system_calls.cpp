#include "vr/simulator/calls.h"
#include "vr/simulator/system.h"

namespace simulator
{
namespace
{
constexpr XrSystemId systemId = 1;

std::vector<XrViewConfigurationType> offeredViews(const SimulatedWorld& world)
{
    switch (world.headset.views) {
    case Views::Stereo:
        return {XR_VIEW_CONFIGURATION_TYPE_PRIMARY_STEREO};
    case Views::Mono:
        return {XR_VIEW_CONFIGURATION_TYPE_PRIMARY_MONO};
    case Views::MonoFirst:
        break;
    }
    return {XR_VIEW_CONFIGURATION_TYPE_PRIMARY_MONO, XR_VIEW_CONFIGURATION_TYPE_PRIMARY_STEREO};
}
} // namespace

void requireSystem(XrSystemId system)
{
    require(system == systemId, XR_ERROR_SYSTEM_INVALID, "no such system");
}

void requireViews(const SimulatedWorld& world, XrViewConfigurationType views)
{
    const auto offered = offeredViews(world);
    require(std::find(offered.begin(), offered.end(), views) != offered.end(),
            XR_ERROR_VIEW_CONFIGURATION_TYPE_UNSUPPORTED, "the view configuration is not offered");
}

std::uint32_t viewCount(XrViewConfigurationType views)
{
    return views == XR_VIEW_CONFIGURATION_TYPE_PRIMARY_STEREO ? 2 : 1;
}

XrResult getSystem(Call& call, XrInstance handle, const XrSystemGetInfo* info, XrSystemId* system)
{
    call.get<Instance>(handle);
    validated(info, XR_TYPE_SYSTEM_GET_INFO);
    validated(system);
    require(info->formFactor == XR_FORM_FACTOR_HEAD_MOUNTED_DISPLAY, XR_ERROR_FORM_FACTOR_UNSUPPORTED,
            "only a headset");
    require(call.runtime.world.hasHeadset, XR_ERROR_FORM_FACTOR_UNAVAILABLE, "so the script says");
    *system = systemId;
    return XR_SUCCESS;
}

XrResult getSystemProperties(Call& call, XrInstance handle, XrSystemId system, XrSystemProperties* properties)
{
    call.get<Instance>(handle);
    validated(properties, XR_TYPE_SYSTEM_PROPERTIES);
    requireSystem(system);
    properties->systemId = system;
    properties->vendorId = 0;
    copyText(properties->systemName, "Simulated Vive");
    properties->graphicsProperties = {largestImage, largestImage, maxLayers};
    properties->trackingProperties = {XR_TRUE, XR_TRUE};
    return XR_SUCCESS;
}

XrResult enumerateEnvironmentBlendModes(Call& call, XrInstance handle, XrSystemId system, XrViewConfigurationType views,
                                        std::uint32_t capacity, std::uint32_t* count, XrEnvironmentBlendMode* modes)
{
    call.get<Instance>(handle);
    requireSystem(system);
    requireViews(call.runtime.world, views);
    writeItems(OutputArray<XrEnvironmentBlendMode>{capacity, count, modes}, call.runtime.world.blendModes);
    return XR_SUCCESS;
}

XrResult enumerateViewConfigurations(Call& call, XrInstance handle, XrSystemId system, std::uint32_t capacity,
                                     std::uint32_t* count, XrViewConfigurationType* types)
{
    call.get<Instance>(handle);
    requireSystem(system);
    writeItems(OutputArray<XrViewConfigurationType>{capacity, count, types}, offeredViews(call.runtime.world));
    return XR_SUCCESS;
}

XrResult getViewConfigurationProperties(Call& call, XrInstance handle, XrSystemId system, XrViewConfigurationType views,
                                        XrViewConfigurationProperties* properties)
{
    call.get<Instance>(handle);
    validated(properties, XR_TYPE_VIEW_CONFIGURATION_PROPERTIES);
    requireSystem(system);
    requireViews(call.runtime.world, views);
    properties->viewConfigurationType = views;
    properties->fovMutable = XR_FALSE;
    return XR_SUCCESS;
}

XrResult enumerateViewConfigurationViews(Call& call, XrInstance handle, XrSystemId system,
                                         XrViewConfigurationType views, std::uint32_t capacity, std::uint32_t* count,
                                         XrViewConfigurationView* out)
{
    call.get<Instance>(handle);
    requireSystem(system);
    requireViews(call.runtime.world, views);
    const Headset& headset = call.runtime.world.headset;
    XrViewConfigurationView view{XR_TYPE_VIEW_CONFIGURATION_VIEW, nullptr, 0, largestImage, 0, largestImage, 1, 1};
    view.recommendedImageRectWidth = static_cast<std::uint32_t>(headset.width);
    view.recommendedImageRectHeight = static_cast<std::uint32_t>(headset.height);
    writeItems(OutputArray<XrViewConfigurationView>{capacity, count, out}, std::vector(viewCount(views), view),
               [](XrViewConfigurationView& to, XrViewConfigurationView from) {
                   validated(&to, XR_TYPE_VIEW_CONFIGURATION_VIEW);
                   from.next = to.next;
                   to = from;
               });
    call.line["size"] = {headset.width, headset.height};
    return XR_SUCCESS;
}

XrResult getOpenGlRequirements(Call& call, XrInstance handle, XrSystemId system,
                               XrGraphicsRequirementsOpenGLKHR* requirements)
{
    Instance& instance = call.get<Instance>(handle);
    validated(requirements, XR_TYPE_GRAPHICS_REQUIREMENTS_OPENGL_KHR);
    requireSystem(system);
    requirements->minApiVersionSupported = call.runtime.world.minOpenGl;
    requirements->maxApiVersionSupported = XR_MAKE_VERSION(4, 6, 0);
    instance.requirementsAsked = true;
    return XR_SUCCESS;
}
} // namespace simulator
