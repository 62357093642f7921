#include "tests/vr/simulator/raw_client.h"

#include <QGuiApplication>
#include <QOpenGLFunctions>
#include <QtGui/qguiapplication_platform.h>
#include <QtGui/qopenglcontext_platform.h>

#include <cstring>

#include <GL/glx.h>
#define XR_USE_PLATFORM_XLIB
#define XR_USE_GRAPHICS_API_OPENGL
#include <openxr/openxr_platform.h>

namespace
{
constexpr XrPosef noPose{{0, 0, 0, 1}, {0, 0, 0}};
constexpr int manyFrames = 1000;

/// Returns the binding of the current context.
XrGraphicsBindingOpenGLXlibKHR currentBinding(QOpenGLContext& gl)
{
    XrGraphicsBindingOpenGLXlibKHR binding{};
    binding.type = XR_TYPE_GRAPHICS_BINDING_OPENGL_XLIB_KHR;
    binding.xDisplay = qGuiApp->nativeInterface<QNativeInterface::QX11Application>()->display();
    binding.glxContext = gl.nativeInterface<QNativeInterface::QGLXContext>()->nativeContext();
    binding.glxDrawable = glXGetCurrentDrawable();
    int id = 0, count = 0, visual = 0;
    glXQueryContext(binding.xDisplay, binding.glxContext, GLX_FBCONFIG_ID, &id);
    const int wanted[] = {GLX_FBCONFIG_ID, id, 0};
    GLXFBConfig* configs = glXChooseFBConfig(binding.xDisplay, DefaultScreen(binding.xDisplay), wanted, &count);
    binding.glxFBConfig = count > 0 ? configs[0] : nullptr;
    glXGetFBConfigAttrib(binding.xDisplay, binding.glxFBConfig, GLX_VISUAL_ID, &visual);
    binding.visualid = static_cast<std::uint32_t>(visual);
    XFree(configs);
    return binding;
}

XrResult askRequirements(XrInstance instance, XrSystemId system)
{
    PFN_xrGetOpenGLGraphicsRequirementsKHR ask = nullptr;
    auto* function = reinterpret_cast<PFN_xrVoidFunction*>(&ask);
    if (const XrResult result = xrGetInstanceProcAddr(instance, "xrGetOpenGLGraphicsRequirementsKHR", function);
        XR_FAILED(result))
        return result;
    XrGraphicsRequirementsOpenGLKHR requirements{};
    requirements.type = XR_TYPE_GRAPHICS_REQUIREMENTS_OPENGL_KHR;
    return ask(instance, system, &requirements);
}
} // namespace

RawClient::RawClient()
{
    QSurfaceFormat format;
    format.setVersion(3, 3);
    format.setProfile(QSurfaceFormat::CoreProfile);
    gl.setFormat(format);
    gl.create();
    surface.setFormat(gl.format());
    surface.create();
    gl.makeCurrent(&surface);
    gl.functions()->glGenFramebuffers(1, &m_framebuffer);
}

RawClient::~RawClient()
{
    gl.makeCurrent(&surface);
    if (instance != XR_NULL_HANDLE)
        xrDestroyInstance(instance);
    gl.functions()->glDeleteFramebuffers(1, &m_framebuffer);
}

XrResult RawClient::createInstance(std::vector<const char*> extensions)
{
    XrInstanceCreateInfo info{};
    info.type = XR_TYPE_INSTANCE_CREATE_INFO;
    std::strncpy(info.applicationInfo.applicationName, "Raw client", XR_MAX_APPLICATION_NAME_SIZE - 1);
    info.applicationInfo.apiVersion = XR_MAKE_VERSION(1, 0, 0);
    info.enabledExtensionCount = static_cast<std::uint32_t>(extensions.size());
    info.enabledExtensionNames = extensions.data();
    if (const XrResult result = xrCreateInstance(&info, &instance); XR_FAILED(result))
        return result;
    const XrSystemGetInfo wanted{XR_TYPE_SYSTEM_GET_INFO, nullptr, XR_FORM_FACTOR_HEAD_MOUNTED_DISPLAY};
    return xrGetSystem(instance, &wanted, &system);
}

XrResult RawClient::createSession()
{
    if (const XrResult result = askRequirements(instance, system); XR_FAILED(result))
        return result;
    const XrGraphicsBindingOpenGLXlibKHR binding = currentBinding(gl);
    const XrSessionCreateInfo info{XR_TYPE_SESSION_CREATE_INFO, &binding, 0, system};
    return xrCreateSession(instance, &info, &session);
}

XrResult RawClient::createSwapchain(const XrSwapchainCreateInfo& info, Eye& eye)
{
    if (const XrResult result = xrCreateSwapchain(session, &info, &eye.swapchain); XR_FAILED(result))
        return result;
    std::uint32_t count = 0;
    xrEnumerateSwapchainImages(eye.swapchain, 0, &count, nullptr);
    std::vector<XrSwapchainImageOpenGLKHR> images(count, {XR_TYPE_SWAPCHAIN_IMAGE_OPENGL_KHR, nullptr, 0});
    auto* first = reinterpret_cast<XrSwapchainImageBaseHeader*>(images.data());
    const XrResult result = xrEnumerateSwapchainImages(eye.swapchain, count, &count, first);
    for (const auto& image : images)
        eye.images.push_back(image.image);
    return result;
}

XrResult RawClient::createSwapchains()
{
    std::uint32_t count = 0;
    XrViewConfigurationView sizes[2]{{XR_TYPE_VIEW_CONFIGURATION_VIEW, nullptr, 0, 0, 0, 0, 0, 0},
                                     {XR_TYPE_VIEW_CONFIGURATION_VIEW, nullptr, 0, 0, 0, 0, 0, 0}};
    if (const XrResult result = xrEnumerateViewConfigurationViews(instance, system, views, 2, &count, sizes);
        XR_FAILED(result))
        return result;
    eyes.assign(count, {});
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::uint32_t width = sizes[i].recommendedImageRectWidth, height = sizes[i].recommendedImageRectHeight;
        eyes[i].size = {static_cast<int>(width), static_cast<int>(height)};
        const XrSwapchainCreateInfo info{XR_TYPE_SWAPCHAIN_CREATE_INFO,
                                         nullptr,
                                         0,
                                         XR_SWAPCHAIN_USAGE_COLOR_ATTACHMENT_BIT,
                                         GL_SRGB8_ALPHA8,
                                         1,
                                         width,
                                         height,
                                         1,
                                         1,
                                         1};
        if (const XrResult result = createSwapchain(info, eyes[i]); XR_FAILED(result))
            return result;
    }
    return XR_SUCCESS;
}

XrResult RawClient::createSpaces()
{
    XrReferenceSpaceCreateInfo info{XR_TYPE_REFERENCE_SPACE_CREATE_INFO, nullptr, XR_REFERENCE_SPACE_TYPE_LOCAL,
                                    noPose};
    if (const XrResult result = xrCreateReferenceSpace(session, &info, &local); XR_FAILED(result))
        return result;
    info.referenceSpaceType = XR_REFERENCE_SPACE_TYPE_VIEW;
    return xrCreateReferenceSpace(session, &info, &view);
}

XrResult RawClient::prepare()
{
    for (const auto step : {&RawClient::createSession, &RawClient::createSwapchains, &RawClient::createSpaces}) {
        if (const XrResult result = (this->*step)(); XR_FAILED(result))
            return result;
    }
    return XR_SUCCESS;
}

XrResult RawClient::enter()
{
    if (const XrResult result = createInstance(); XR_FAILED(result))
        return result;
    if (const XrResult result = prepare(); XR_FAILED(result))
        return result;
    return framesUntil(XR_SESSION_STATE_FOCUSED);
}

XrResult RawClient::poll()
{
    for (;;) {
        XrEventDataBuffer event{};
        event.type = XR_TYPE_EVENT_DATA_BUFFER;
        const XrResult result = xrPollEvent(instance, &event);
        if (result != XR_SUCCESS)
            return result == XR_EVENT_UNAVAILABLE ? XR_SUCCESS : result;
        if (event.type != XR_TYPE_EVENT_DATA_SESSION_STATE_CHANGED) {
            otherEvents.push_back(event);
            continue;
        }
        states.push_back(reinterpret_cast<const XrEventDataSessionStateChanged&>(event).state);
        if (states.back() == XR_SESSION_STATE_READY) {
            const XrSessionBeginInfo info{XR_TYPE_SESSION_BEGIN_INFO, nullptr, views};
            isRunning = XR_SUCCEEDED(xrBeginSession(session, &info));
        } else if (states.back() == XR_SESSION_STATE_STOPPING) {
            isRunning = false;
            xrEndSession(session);
        }
    }
}

XrResult RawClient::frame(const std::function<void()>& inFrame)
{
    if (const XrResult result = poll(); XR_FAILED(result) || !isRunning)
        return result;
    if (const XrResult result = xrWaitFrame(session, nullptr, &frameState); XR_FAILED(result))
        return result;
    if (const XrResult result = xrBeginFrame(session, nullptr); XR_FAILED(result))
        return result;
    if (inFrame)
        inFrame();
    return submit();
}

XrResult RawClient::submit()
{
    std::vector<XrCompositionLayerProjectionView> projected;
    if (frameState.shouldRender == XR_TRUE)
        putProjection(projected);
    const XrCompositionLayerProjection layer{XR_TYPE_COMPOSITION_LAYER_PROJECTION,         nullptr,         0, local,
                                             static_cast<std::uint32_t>(projected.size()), projected.data()};
    const auto* layers = reinterpret_cast<const XrCompositionLayerBaseHeader*>(&layer);
    const XrFrameEndInfo info{XR_TYPE_FRAME_END_INFO,          nullptr,
                              frameState.predictedDisplayTime, XR_ENVIRONMENT_BLEND_MODE_OPAQUE,
                              projected.empty() ? 0U : 1U,     &layers};
    return xrEndFrame(session, &info);
}

void RawClient::putProjection(std::vector<XrCompositionLayerProjectionView>& projected)
{
    const XrViewLocateInfo info{XR_TYPE_VIEW_LOCATE_INFO, nullptr, views, frameState.predictedDisplayTime, local};
    XrViewState state{XR_TYPE_VIEW_STATE, nullptr, 0};
    std::vector<XrView> located(eyes.size(), {XR_TYPE_VIEW, nullptr, noPose, {}});
    std::uint32_t count = 0;
    xrLocateViews(session, &info, &state, static_cast<std::uint32_t>(located.size()), &count, located.data());
    if ((state.viewStateFlags & XR_VIEW_STATE_ORIENTATION_VALID_BIT) == 0)
        return;
    for (std::size_t i = 0; i < eyes.size(); ++i) {
        std::uint32_t image = 0;
        xrAcquireSwapchainImage(eyes[i].swapchain, nullptr, &image);
        const XrSwapchainImageWaitInfo wait{XR_TYPE_SWAPCHAIN_IMAGE_WAIT_INFO, nullptr, XR_INFINITE_DURATION};
        xrWaitSwapchainImage(eyes[i].swapchain, &wait);
        draw(eyes[i], image, i == 0);
        xrReleaseSwapchainImage(eyes[i].swapchain, nullptr);
        projected.push_back({XR_TYPE_COMPOSITION_LAYER_PROJECTION_VIEW,
                             nullptr,
                             located[i].pose,
                             located[i].fov,
                             {eyes[i].swapchain, {{0, 0}, eyes[i].size}, 0}});
    }
}

void RawClient::draw(const Eye& eye, std::uint32_t image, bool isLeft)
{
    QOpenGLFunctions& f = *gl.functions();
    f.glBindFramebuffer(GL_FRAMEBUFFER, m_framebuffer);
    f.glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, eye.images[image], 0);
    f.glEnable(GL_SCISSOR_TEST);
    f.glScissor(0, 0, eye.size.width, eye.size.height / 2);
    f.glClearColor(isLeft ? 1 : 0, isLeft ? 0 : 1, 0, 1);
    f.glClear(GL_COLOR_BUFFER_BIT);
    f.glScissor(0, eye.size.height / 2, eye.size.width, eye.size.height - eye.size.height / 2);
    f.glClearColor(0, isLeft ? 0 : 1, isLeft ? 1 : 0, 1);
    f.glClear(GL_COLOR_BUFFER_BIT);
    f.glDisable(GL_SCISSOR_TEST);
}

XrResult RawClient::framesUntil(XrSessionState state)
{
    for (int i = 0; i < manyFrames; ++i) {
        if (const XrResult result = frame(); XR_FAILED(result))
            return result;
        if (const XrResult result = poll(); XR_FAILED(result))
            return result;
        if (!states.empty() && states.back() == state)
            return XR_SUCCESS;
    }
    return XR_ERROR_RUNTIME_FAILURE;
}

XrResult RawClient::leave()
{
    if (const XrResult result = xrRequestExitSession(session); XR_FAILED(result))
        return result;
    return framesUntil(XR_SESSION_STATE_EXITING);
}
