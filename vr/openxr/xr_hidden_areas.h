#pragma once

#include "vr/gl/eye_image.h"
#include "vr/openxr/xr_session.h"

namespace vr
{
/// The areas of each eye's picture that its lens hides, if the runtime reports them (XR_KHR_visibility_mask). Their
/// pixels need not be drawn. If the runtime refuses a query, nothing counts as hidden.
class HiddenAreas
{
public:
    HiddenAreas(const Instance& instance, const Session& session);

    /// Reads the area of one eye again, because the runtime reports that it has changed.
    void handle(const XrEventDataVisibilityMaskChangedKHR& event);
    /// Reads the areas of all eyes again.
    void refresh();
    /// Returns the hidden area of one eye; empty if nothing is hidden.
    const HiddenArea& of(std::size_t eye) const { return m_areas[eye]; }

private:
    void read(std::size_t eye);
    /// Reads the area of one eye from the runtime. Throws XrError.
    HiddenArea ask(std::uint32_t eye) const;

    XrSession m_session;
    XrViewConfigurationType m_viewConfiguration;
    PFN_xrGetVisibilityMaskKHR m_getMask = nullptr; ///< null: the runtime does not offer the extension
    std::vector<HiddenArea> m_areas;                ///< indexed by eye
};
} // namespace vr
