#pragma once

#include "vr/gl/gl_binding.h"
#include "vr/openxr/xr_blending.h"
#include "vr/openxr/xr_handle.h"
#include "vr/openxr/xr_instance.h"
#include "vr/openxr/xr_swapchain.h"

#include <QVersionNumber>

#include <span>
#include <vector>

namespace vr
{
/// Timing of the frame to be made, as the runtime reports it.
struct FrameTime
{
    XrTime display = 0;    ///< predicted time at which the frame is seen, nanoseconds
    XrDuration period = 0; ///< time from one frame to the next, nanoseconds
    bool shouldRender = false;
};

/// Refresh rate that the headset is asked for if its runtime lets applications choose, Hz. It is the rate of a Vive,
/// for which performance is measured. A lower rate is tiring; some machines cannot draw a higher one in time.
inline constexpr float wantedRefreshRate = 90;

/// Returns the lowest OpenGL version that the runtime asks for, although it may accept an earlier one. OpenXR requires
/// this query before a session is made. Throws XrError.
QVersionNumber minOpenGl(const Instance& instance);

/// A session with one headset, and the sizes and formats of the images that the runtime offers. Precondition: the
/// context described by the binding is current at every call. All members except those that only return a value throw
/// XrError.
class Session
{
public:
    Session(const Instance& instance, const GlBinding& binding);

    XrSession handle() const { return m_handle.get(); }
    /// Returns the image size of each view, as the runtime recommends it for this session.
    const std::vector<ImageSize>& imageSizes() const { return m_imageSizes; }
    /// Returns the formats that the images may have, the best first. The runtime may refuse one that it offers.
    const std::vector<ImageFormat>& imageFormats() const { return m_imageFormats; }
    /// Returns the formats that the depth images may have, the best first; empty if the runtime wants no depth with the
    /// pictures (XR_KHR_composition_layer_depth).
    const std::vector<ImageFormat>& depthFormats() const { return m_depthFormats; }
    XrViewConfigurationType viewConfiguration() const { return m_viewConfiguration; }
    /// Returns whether the headset can show the real room behind the picture.
    bool offersPassthrough() const { return vr::offersPassthrough(m_blendModes); }
    /// Shows or hides the real room from the next frame's end on, as far as the headset can.
    void setPassthrough(bool isOn) { m_blending = blendingOf(m_blendModes, isOn); }
    bool hasPassthrough() const { return m_blending.hasPassthrough; }

    void begin();
    void end();
    void requestExit();

    /// Blocks until the runtime wants a frame.
    FrameTime waitFrame();

private:
    friend class Frame;

    XrViewConfigurationType m_viewConfiguration;
    std::vector<XrEnvironmentBlendMode> m_blendModes; ///< modes that the runtime offers
    Blending m_blending;
    std::vector<ImageSize> m_imageSizes;
    SessionHandle m_handle;
    std::vector<ImageFormat> m_imageFormats, m_depthFormats;
};

/// A frame that has begun. It is always ended: by show(), or without a picture by the destructor.
class Frame
{
public:
    Frame(Session& session, const FrameTime& time);
    ~Frame();
    Frame(const Frame&) = delete;
    Frame& operator=(const Frame&) = delete;

    /// Ends the frame with a picture of these views. An empty list ends it without a picture.
    void show(XrSpace space, std::span<const XrCompositionLayerProjectionView> views);

private:
    Session& m_session;
    XrTime m_display;
    bool m_isEnded = false;
};
} // namespace vr
