#include "vr/openxr/xr_session.h"

#define XR_USE_GRAPHICS_API_OPENGL
#include <openxr/openxr_platform.h>

#include <QtGlobal>

#include <algorithm>
#include <cmath>

namespace vr
{
namespace
{
/// Returns two eyes if the runtime offers that, else one.
XrViewConfigurationType viewConfigurationOf(const Instance& instance)
{
    const auto offered = enumerate(
        "xrEnumerateViewConfigurations", XrViewConfigurationType{}, [&](auto capacity, auto* count, auto* items) {
            return xrEnumerateViewConfigurations(instance.handle(), instance.system(), capacity, count, items);
        });
    for (const auto type : {XR_VIEW_CONFIGURATION_TYPE_PRIMARY_STEREO, XR_VIEW_CONFIGURATION_TYPE_PRIMARY_MONO})
        if (std::find(offered.begin(), offered.end(), type) != offered.end())
            return type;
    throw XrError("xrEnumerateViewConfigurations", XR_ERROR_VIEW_CONFIGURATION_TYPE_UNSUPPORTED);
}

std::vector<XrEnvironmentBlendMode> blendModesOf(const Instance& instance, XrViewConfigurationType type)
{
    return enumerate(
        "xrEnumerateEnvironmentBlendModes", XrEnvironmentBlendMode{}, [&](auto capacity, auto* count, auto* items) {
            return xrEnumerateEnvironmentBlendModes(instance.handle(), instance.system(), type, capacity, count, items);
        });
}

std::vector<ImageSize> imageSizesOf(const Instance& instance, XrViewConfigurationType type)
{
    XrViewConfigurationView blank{};
    blank.type = XR_TYPE_VIEW_CONFIGURATION_VIEW;
    const auto views =
        enumerate("xrEnumerateViewConfigurationViews", blank, [&](auto capacity, auto* count, auto* items) {
            return xrEnumerateViewConfigurationViews(instance.handle(), instance.system(), type, capacity, count,
                                                     items);
        });
    std::vector<ImageSize> sizes;
    for (const XrViewConfigurationView& view : views)
        sizes.push_back(
            {static_cast<int>(view.recommendedImageRectWidth), static_cast<int>(view.recommendedImageRectHeight)});
    return sizes;
}

SessionHandle makeSession(const Instance& instance, const GlBinding& binding)
{
    minOpenGl(instance);
    const XrSessionCreateInfo info{XR_TYPE_SESSION_CREATE_INFO, binding.next(), 0, instance.system()};
    XrSession made = XR_NULL_HANDLE;
    check(xrCreateSession(instance.handle(), &info, &made), "xrCreateSession");
    return SessionHandle(made);
}

std::vector<std::int64_t> formatsOf(XrSession session)
{
    return enumerate("xrEnumerateSwapchainFormats", std::int64_t{}, [&](auto capacity, auto* count, auto* items) {
        return xrEnumerateSwapchainFormats(session, capacity, count, items);
    });
}

std::vector<ImageFormat> depthFormatsOf(const Instance& instance, XrSession session)
{
    const bool isWanted = instance.has(XR_KHR_COMPOSITION_LAYER_DEPTH_EXTENSION_NAME);
    return isWanted ? usableDepthFormats(formatsOf(session)) : std::vector<ImageFormat>();
}

/// Requests the offered rate that is nearest to wantedRefreshRate. Throws XrError.
void requestRefreshRate(const Instance& instance, XrSession session)
{
    const auto enumerateRates =
        instance.function<PFN_xrEnumerateDisplayRefreshRatesFB>("xrEnumerateDisplayRefreshRatesFB");
    const auto request = instance.function<PFN_xrRequestDisplayRefreshRateFB>("xrRequestDisplayRefreshRateFB");
    const std::vector<float> offered =
        enumerate("xrEnumerateDisplayRefreshRatesFB", 0.0F, [&](auto capacity, auto* count, auto* items) {
            return enumerateRates(session, capacity, count, items);
        });
    const auto nearest =
        std::ranges::min_element(offered, {}, [](float rate) { return std::abs(rate - wantedRefreshRate); });
    if (nearest != offered.end())
        check(request(session, *nearest), "xrRequestDisplayRefreshRateFB");
}

/// Requests the wanted refresh rate. A refusal is no error: the runtime keeps its own rate.
void tryRefreshRate(const Instance& instance, XrSession session)
{
    try {
        requestRefreshRate(instance, session);
    } catch (const XrError& error) {
        qInfo("The OpenXR runtime keeps its frame rate: %s", qPrintable(error.text()));
    }
}
} // namespace

QVersionNumber minOpenGl(const Instance& instance)
{
    XrGraphicsRequirementsOpenGLKHR requirements{};
    requirements.type = XR_TYPE_GRAPHICS_REQUIREMENTS_OPENGL_KHR;
    check(instance.function<PFN_xrGetOpenGLGraphicsRequirementsKHR>("xrGetOpenGLGraphicsRequirementsKHR")(
              instance.handle(), instance.system(), &requirements),
          "xrGetOpenGLGraphicsRequirementsKHR");
    const XrVersion least = requirements.minApiVersionSupported;
    return {static_cast<int>(XR_VERSION_MAJOR(least)), static_cast<int>(XR_VERSION_MINOR(least))};
}

Session::Session(const Instance& instance, const GlBinding& binding)
    : m_viewConfiguration(viewConfigurationOf(instance))
    , m_blendModes(blendModesOf(instance, m_viewConfiguration))
    , m_blending(blendingOf(m_blendModes, false))
    , m_imageSizes(imageSizesOf(instance, m_viewConfiguration))
    , m_handle(makeSession(instance, binding))
    , m_imageFormats(usableFormats(formatsOf(handle())))
    , m_depthFormats(depthFormatsOf(instance, handle()))
{
    if (instance.has(XR_FB_DISPLAY_REFRESH_RATE_EXTENSION_NAME))
        tryRefreshRate(instance, handle());
}

void Session::begin()
{
    const XrSessionBeginInfo info{XR_TYPE_SESSION_BEGIN_INFO, nullptr, m_viewConfiguration};
    check(xrBeginSession(handle(), &info), "xrBeginSession");
}

void Session::end()
{
    check(xrEndSession(handle()), "xrEndSession");
}

void Session::requestExit()
{
    check(xrRequestExitSession(handle()), "xrRequestExitSession");
}

FrameTime Session::waitFrame()
{
    XrFrameState state{};
    state.type = XR_TYPE_FRAME_STATE;
    check(xrWaitFrame(handle(), nullptr, &state), "xrWaitFrame");
    return {state.predictedDisplayTime, state.predictedDisplayPeriod, state.shouldRender == XR_TRUE};
}

Frame::Frame(Session& session, const FrameTime& time) : m_session(session), m_display(time.display)
{
    check(xrBeginFrame(session.handle(), nullptr), "xrBeginFrame");
}

Frame::~Frame()
{
    if (m_isEnded)
        return;
    const XrFrameEndInfo info{XR_TYPE_FRAME_END_INFO, nullptr, m_display, m_session.m_blending.mode, 0, nullptr};
    xrEndFrame(m_session.handle(), &info); // result ignored: the earlier error that led here is the one reported
}

void Frame::show(XrSpace space, std::span<const XrCompositionLayerProjectionView> views)
{
    XrCompositionLayerProjection picture{};
    picture.type = XR_TYPE_COMPOSITION_LAYER_PROJECTION;
    if (m_session.hasPassthrough()) // the scene's colours are multiplied by their alpha already
        picture.layerFlags = XR_COMPOSITION_LAYER_BLEND_TEXTURE_SOURCE_ALPHA_BIT;
    picture.space = space;
    picture.viewCount = static_cast<std::uint32_t>(views.size());
    picture.views = views.data();
    const auto* layer = reinterpret_cast<const XrCompositionLayerBaseHeader*>(&picture);
    const XrFrameEndInfo info{XR_TYPE_FRAME_END_INFO,  nullptr, m_display, m_session.m_blending.mode,
                              views.empty() ? 0U : 1U, &layer};
    m_isEnded = true;
    check(xrEndFrame(m_session.handle(), &info), "xrEndFrame");
}
} // namespace vr
