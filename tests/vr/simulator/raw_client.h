#pragma once

#include <QOffscreenSurface>
#include <QOpenGLContext>

#include <openxr/openxr.h>

#include <functional>
#include <vector>

#define QSUCCEEDS(EXPRESSION) QCOMPARE(EXPRESSION, XR_SUCCESS)

/// The least that an OpenXR client can be: it does as the specification says and leaves what is wrong to be done to the
/// test. What a test wants to see is public. Everything is on one thread.
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

    /// Each returns the first result that is an error, or the last.
    XrResult createInstance(std::vector<const char*> extensions = {"XR_KHR_opengl_enable"});
    XrResult createSession();
    XrResult createSwapchain(const XrSwapchainCreateInfo& info, Eye& eye);
    XrResult createSwapchains();
    XrResult createSpaces();
    /// The three above.
    XrResult prepare();
    /// From nothing to the focus.
    XrResult enter();

    /// Takes all events, and begins and ends the session as they say.
    XrResult poll();
    /// poll() and one frame, of both eyes where the runtime says that it is seen; `inFrame` runs between begin and end.
    XrResult frame(const std::function<void()>& inFrame = {});
    /// Frames until the session is in that state, or an error, or many frames have passed.
    XrResult framesUntil(XrSessionState state);
    /// Asks to leave, and follows until the session may be destroyed.
    XrResult leave();

    /// For the next frames: what the eyes see, the left one's lower half red and its upper half blue, the right one all
    /// green.
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
    std::vector<XrSessionState> states; ///< all that were told
    std::vector<XrEventDataBuffer> otherEvents;
    XrFrameState frameState{XR_TYPE_FRAME_STATE, nullptr, 0, 0, XR_FALSE};
    bool isRunning = false;

private:
    XrResult submit();

    unsigned int m_framebuffer = 0;
};
