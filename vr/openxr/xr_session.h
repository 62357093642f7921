#pragma once

#include "vr/gl/gl_binding.h"
#include "vr/openxr/xr_handle.h"
#include "vr/openxr/xr_instance.h"
#include "vr/openxr/xr_swapchain.h"

#include <QVersionNumber>

#include <span>
#include <vector>

namespace vr
{
/// What the runtime says of the frame that is to be made.
struct FrameTime
{
    XrTime display = 0;    ///< when it will be seen
    XrDuration period = 0; ///< from one frame to the next
    bool shouldRender = false;
};

/// Frames a second at which a headset is asked to show ours, where it can be asked: as a Vive does, for which all is
/// measured. Less tires; more is not drawn in time everywhere.
inline constexpr float wantedRefreshRate = 90;

/// The least version of OpenGL that the runtime asks for; it may take less all the same. OpenXR wants it to be asked
/// for before a session is made. Throws XrError.
QVersionNumber leastOpenGl(const Instance& instance);

/// A session with one headset, and what the runtime wants to be given for it. Members throw XrError; the context that
/// the binding tells of is current whenever one of them is called.
class Session
{
public:
    Session(const Instance& instance, const GlBinding& binding);

    XrSession handle() const { return m_handle.get(); }
    /// One for each view, as the runtime recommends; it may do otherwise in the next session.
    const std::vector<ImageSize>& imageSizes() const { return m_imageSizes; }
    const ImageFormat& imageFormat() const { return m_imageFormat; }
    /// Format of the depth that the runtime wants to be given with the pictures (XR_KHR_composition_layer_depth);
    /// nothing where it does not.
    const std::optional<ImageFormat>& depthFormat() const { return m_depthFormat; }
    XrViewConfigurationType viewConfiguration() const { return m_viewConfiguration; }

    void begin();
    void end();
    void requestExit();

    /// Blocks until the runtime wants a frame.
    FrameTime waitFrame();

private:
    friend class Frame;

    XrViewConfigurationType m_viewConfiguration;
    XrEnvironmentBlendMode m_blendMode;
    std::vector<ImageSize> m_imageSizes;
    SessionHandle m_handle;
    ImageFormat m_imageFormat;
    std::optional<ImageFormat> m_depthFormat;
};

/// A frame that is begun, and is ended whatever happens: by show(), or without a picture when this goes.
class Frame
{
public:
    Frame(Session& session, const FrameTime& time);
    ~Frame();
    Frame(const Frame&) = delete;
    Frame& operator=(const Frame&) = delete;

    /// No views: no picture.
    void show(XrSpace space, std::span<const XrCompositionLayerProjectionView> views);

private:
    Session& m_session;
    XrTime m_display;
    bool m_isEnded = false;
};
} // namespace vr
