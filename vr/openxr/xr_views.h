#pragma once

#include "vr/gl/eye_image.h"
#include "vr/openxr/xr_hidden_areas.h"
#include "vr/openxr/xr_session.h"

#include <functional>

namespace vr
{
/// The pictures of the eyes: one eye, or two, left before right. Precondition: the session's context is current. The
/// constructor, locate() and draw() throw XrError.
class Views
{
public:
    Views(const Instance& instance, const Session& session);

    HiddenAreas& hidden() { return m_hidden; }
    std::size_t count() const { return m_images.swapchains.size(); }

    /// Reads the poses of the eyes at `time`. Returns false while they are unknown; nothing can be shown then. If only
    /// the position is lost, the eyes keep their last position.
    bool locate(XrSpace room, XrTime time);

    /// Acquires the image of one eye, lets `draw` fill it, and releases it even if `draw` throws. To be called for each
    /// eye once between locate() and the frame's end.
    void draw(std::size_t eye, const std::function<void(const EyeImage&, const EyeView&)>& draw);

    /// Returns the pictures drawn, for Frame::show(). Valid until the next locate().
    std::span<const XrCompositionLayerProjectionView> pictures() const { return m_pictures; }

private:
    /// Swapchains of one format, indexed by eye.
    struct Images
    {
        ImageFormat format;
        std::vector<Swapchain> swapchains;
    };

    static Images makeImages(const Session& session, const std::vector<ImageFormat>& formats);
    void makeDepths(const Session& session);
    EyeView viewOf(std::size_t eye) const;

    XrSession m_session;
    XrViewConfigurationType m_viewConfiguration;
    HiddenAreas m_hidden;
    bool m_isKnown = false; ///< the positions of the eyes were known at least once
    Images m_images;
    std::vector<XrView> m_views;
    std::vector<XrCompositionLayerProjectionView> m_pictures;
    Images m_depths; ///< no swapchains: the runtime wants no depth, or refuses depth images
    /// Depth information of each eye, to which m_pictures points.
    std::vector<XrCompositionLayerDepthInfoKHR> m_depthInfos;
};
} // namespace vr
