#pragma once

#include <QOffscreenSurface>
#include <QOpenGLContext>

#include <openxr/openxr.h>

#include <functional>
#include <vector>

#define QSUCCEEDS(EXPRESSION) QCOMPARE(EXPRESSION, XR_SUCCESS)

/// A minimal OpenXR client that follows the specification. Tests provoke errors through its public members. Uses one
/// thread.
class RawClient
{
public:
    struct Eye
    {
        XrSwapchain swapchain = XR_NULL_HANDLE;
        std::vector<unsigned int> images;
        XrExtent2Di size{};
    };

    RawClient();
    ~RawClient();
    RawClient(const RawClient&) = delete;
    RawClient& operator=(const RawClient&) = delete;

    /// Each of these functions returns the first error, or else the last result.
    XrResult createInstance(std::vector<const char*> extensions = {"XR_KHR_opengl_enable"});
    XrResult createSession();
    XrResult createSwapchain(const XrSwapchainCreateInfo& info, Eye& eye);
    XrResult createSwapchains();
    XrResult createSpaces();
    /// Calls createSession(), createSwapchains() and createSpaces().
    XrResult prepare();
    /// Does everything from creating the instance to having the focus.
    XrResult enter();

    /// Handles all events, and begins and ends the session accordingly.
    XrResult poll();
    /// Calls poll() and submits one frame, with both eyes if the runtime says that it is visible. `inFrame` is called
    /// between xrBeginFrame and xrEndFrame.
    XrResult frame(const std::function<void()>& inFrame = {});
    /// Submits frames until the session is in this state, an error occurs, or 1000 frames have passed.
    XrResult framesUntil(XrSessionState state);
    /// Requests to exit, and continues until the session may be destroyed.
    XrResult leave();

    /// Draws an eye's image: red in the lower half and blue in the upper half for the left eye, all green for the right
    /// one.
    void draw(const Eye& eye, std::uint32_t image, bool isLeft);
    void putProjection(std::vector<XrCompositionLayerProjectionView>& views);

    QOpenGLContext gl;
    QOffscreenSurface surface;
    XrInstance instance = XR_NULL_HANDLE;
    XrSystemId system = XR_NULL_SYSTEM_ID;
    XrSession session = XR_NULL_HANDLE;
    XrViewConfigurationType views = XR_VIEW_CONFIGURATION_TYPE_PRIMARY_STEREO;
    XrSpace local = XR_NULL_HANDLE, view = XR_NULL_HANDLE;
    std::vector<Eye> eyes;
    std::vector<XrSessionState> states; ///< all states that were reported
    std::vector<XrEventDataBuffer> otherEvents;
    XrFrameState frameState{XR_TYPE_FRAME_STATE, nullptr, 0, 0, XR_FALSE};
    bool isRunning = false;

private:
    XrResult submit();

    unsigned int m_framebuffer = 0;
};
