#include "vr/openxr/xr_hidden_areas.h"

#include "vr/openxr/xr_result.h"

#include <QtGlobal>

#include <algorithm>

namespace vr
{
namespace
{
/// Expands indexed triangles to three points each. Returns an empty area if an index is out of range or a triangle is
/// incomplete.
HiddenArea triangles(const std::vector<XrVector2f>& points, const std::vector<std::uint32_t>& indices)
{
    HiddenArea area;
    const bool isWhole =
        indices.size() % 3 == 0 && std::ranges::all_of(indices, [&](std::uint32_t i) { return i < points.size(); });
    for (std::size_t i = 0; isWhole && i < indices.size(); ++i)
        area.emplace_back(points[indices[i]].x, points[indices[i]].y);
    return area;
}

/// Logs that the runtime refuses to report hidden areas. This is no error: all pixels are drawn then.
void noteRefusal(const XrError& error)
{
    qInfo("The OpenXR runtime tells no hidden area: %s", qPrintable(error.text()));
}
} // namespace

HiddenAreas::HiddenAreas(const Instance& instance, const Session& session)
    : m_session(session.handle())
    , m_viewConfiguration(session.viewConfiguration())
    , m_areas(session.imageSizes().size())
{
    if (!instance.has(XR_KHR_VISIBILITY_MASK_EXTENSION_NAME))
        return;
    try {
        m_getMask = instance.function<PFN_xrGetVisibilityMaskKHR>("xrGetVisibilityMaskKHR");
    } catch (const XrError& error) {
        noteRefusal(error);
    }
    refresh();
}

void HiddenAreas::refresh()
{
    for (std::size_t eye = 0; eye < m_areas.size() && m_getMask; ++eye)
        read(eye);
}

void HiddenAreas::handle(const XrEventDataVisibilityMaskChangedKHR& event)
{
    const bool isOurs = event.session == m_session && event.viewConfigurationType == m_viewConfiguration;
    if (m_getMask && isOurs && event.viewIndex < m_areas.size())
        read(event.viewIndex);
}

void HiddenAreas::read(std::size_t eye)
{
    m_areas[eye].clear();
    try {
        m_areas[eye] = ask(static_cast<std::uint32_t>(eye));
    } catch (const XrError& error) {
        noteRefusal(error);
    }
}

/// Queries the sizes and then the data. Repeats both if the mask has grown in between.
HiddenArea HiddenAreas::ask(std::uint32_t eye) const
{
    const char* const call = "xrGetVisibilityMaskKHR";
    const auto getMask = [&](XrVisibilityMaskKHR& mask) {
        return m_getMask(m_session, m_viewConfiguration, eye, XR_VISIBILITY_MASK_TYPE_HIDDEN_TRIANGLE_MESH_KHR, &mask);
    };
    for (int growths = 0;; ++growths) {
        XrVisibilityMaskKHR mask{};
        mask.type = XR_TYPE_VISIBILITY_MASK_KHR;
        check(getMask(mask), call);
        std::vector<XrVector2f> points(mask.vertexCountOutput);
        std::vector<std::uint32_t> indices(mask.indexCountOutput);
        if (points.empty() || indices.empty())
            return {};
        mask.vertexCapacityInput = mask.vertexCountOutput;
        mask.vertices = points.data();
        mask.indexCapacityInput = mask.indexCountOutput;
        mask.indices = indices.data();
        const XrResult result = getMask(mask);
        if (result == XR_ERROR_SIZE_INSUFFICIENT && growths < maxGrowths)
            continue;
        check(result, call);
        points.resize(mask.vertexCountOutput);
        indices.resize(mask.indexCountOutput);
        return triangles(points, indices);
    }
}
} // namespace vr
