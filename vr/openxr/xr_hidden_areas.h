#pragma once

#include "vr/gl/eye_image.h"
#include "vr/openxr/xr_session.h"

namespace vr
{
/// Areas of each eye's picture that its lens hides, where the runtime tells it (XR_KHR_visibility_mask): pixels that
/// nobody has to draw. A refusal is no error: nothing is hidden then.
class HiddenAreas
{
public:
    HiddenAreas(const Instance& instance, const Session& session);

    /// The runtime says that those of an eye have changed.
    void handle(const XrEventDataVisibilityMaskChangedKHR& event);
    /// Reads all of them anew.
    void refresh();
    /// Empty where nothing is hidden.
    const HiddenArea& of(std::size_t eye) const { return m_areas[eye]; }

private:
    void read(std::size_t eye);
    /// Throws XrError.
    HiddenArea ask(std::uint32_t eye) const;

    XrSession m_session;
    XrViewConfigurationType m_viewConfiguration;
    PFN_xrGetVisibilityMaskKHR m_getMask = nullptr; ///< null where it is not offered
    std::vector<HiddenArea> m_areas;                ///< by eye
};
} // namespace vr
