#pragma once

#include "vr/gl/eye_image.h"
#include "vr/openxr/xr_hidden_areas.h"
#include "vr/openxr/xr_session.h"

#include <functional>

namespace vr
{
/// What each eye is shown: one, or two, left before right. Members throw XrError; the session's context is current.
class Views
{
public:
    Views(const Instance& instance, const Session& session);

    HiddenAreas& hidden() { return m_hidden; }
    std::size_t count() const { return m_swapchains.size(); }

    /// Where the eyes will be; false while that is not known, and nothing can be shown. What is lost of them for a
    /// while stays where it was.
    bool locate(XrSpace room, XrTime time);

    /// To be called for each, once between locate() and the frame's end; `draw` fills the image. It is given back
    /// whatever happens.
    void draw(std::size_t eye, const std::function<void(const EyeImage&, const EyeView&)>& draw);

    /// What was drawn, for Frame::show(), until the next locate().
    std::span<const XrCompositionLayerProjectionView> pictures() const { return m_pictures; }

private:
    void makeDepths(const Session& session);
    EyeView viewOf(std::size_t eye) const;

    XrSession m_session;
    XrViewConfigurationType m_viewConfiguration;
    ImageFormat m_format, m_depthFormat;
    HiddenAreas m_hidden;
    bool m_isKnown = false; ///< the places are, from now or from before
    std::vector<Swapchain> m_swapchains;
    std::vector<XrView> m_views;
    std::vector<XrCompositionLayerProjectionView> m_pictures;
    std::vector<Swapchain> m_depths;                          ///< by eye; none where the runtime wants no depth
    std::vector<XrCompositionLayerDepthInfoKHR> m_depthInfos; ///< the pictures lead to them
};
} // namespace vr
