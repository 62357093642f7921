#include "vr/openxr/xr_views.h"

#include "vr/openxr/xr_convert.h"

#include <QtGlobal>

#include <algorithm>

namespace vr
{
namespace
{
/// Clip planes, metres: nearer than a wand in front of the face, and farther than any floor.
constexpr float nearPlane = 0.03F;
constexpr float farPlane = 60;

constexpr XrView unknownView{XR_TYPE_VIEW, nullptr, {{0, 0, 0, 1}, {0, 0, 0}}, {}};

/// Owns an acquired image of a swapchain, and releases it.
class Acquired
{
public:
    explicit Acquired(Swapchain& from) : m_from(from), m_texture(from.acquire()) {}
    ~Acquired()
    {
        if (m_isHeld)
            xrReleaseSwapchainImage(m_from.handle(),
                                    nullptr); // result ignored: the earlier error that led here is the one reported
    }
    Acquired(const Acquired&) = delete;
    Acquired& operator=(const Acquired&) = delete;

    unsigned int texture() const { return m_texture; }
    void release()
    {
        m_isHeld = false;
        m_from.release();
    }

private:
    Swapchain& m_from;
    unsigned int m_texture;
    bool m_isHeld = true;
};
} // namespace

Views::Views(const Instance& instance, const Session& session)
    : m_session(session.handle())
    , m_viewConfiguration(session.viewConfiguration())
    , m_format(session.imageFormat())
    , m_hidden(instance, session)
    , m_views(session.imageSizes().size(), unknownView)
{
    for (const ImageSize& size : session.imageSizes())
        m_swapchains.emplace_back(m_session, session.imageFormat(), size);
    if (session.depthFormat())
        makeDepths(session);
}

/// Makes a swapchain of depth images for each eye. A runtime that refuses gets no depth.
void Views::makeDepths(const Session& session)
{
    m_depthFormat = *session.depthFormat();
    try {
        for (const ImageSize& size : session.imageSizes())
            m_depths.emplace_back(m_session, m_depthFormat, size);
    } catch (const XrError& error) {
        m_depths.clear();
        qInfo("The OpenXR runtime takes no depth: %s", qPrintable(error.text()));
    }
    XrCompositionLayerDepthInfoKHR info{};
    info.type = XR_TYPE_COMPOSITION_LAYER_DEPTH_INFO_KHR;
    info.maxDepth = 1;
    info.nearZ = nearPlane;
    info.farZ = farPlane;
    for (const Swapchain& depth : m_depths) {
        info.subImage = {depth.handle(), {{0, 0}, {depth.size().width, depth.size().height}}, 0};
        m_depthInfos.push_back(info);
    }
}

bool Views::locate(XrSpace room, XrTime time)
{
    m_pictures.clear();
    const XrViewLocateInfo info{XR_TYPE_VIEW_LOCATE_INFO, nullptr, m_viewConfiguration, time, room};
    XrViewState state{};
    state.type = XR_TYPE_VIEW_STATE;
    std::vector<XrView> views(count(), unknownView);
    std::uint32_t located = 0;
    check(xrLocateViews(m_session, &info, &state, static_cast<std::uint32_t>(views.size()), &located, views.data()),
          "xrLocateViews");
    const bool hasPlace =
        (state.viewStateFlags & XR_VIEW_STATE_POSITION_VALID_BIT) != 0 &&
        std::ranges::all_of(views, [](const XrView& view) { return isFinitePosition(view.pose.position); });
    const bool hasTurn =
        (state.viewStateFlags & XR_VIEW_STATE_ORIENTATION_VALID_BIT) != 0 &&
        std::ranges::all_of(views, [](const XrView& view) { return isRotation(view.pose.orientation); });
    if (located != count() || !hasTurn)
        return false;
    for (std::size_t eye = 0; eye < count(); ++eye) {
        if (!hasPlace)
            views[eye].pose.position = m_views[eye].pose.position;
        m_views[eye] = views[eye];
    }
    m_isKnown = m_isKnown || hasPlace;
    return m_isKnown;
}

void Views::draw(std::size_t eye, const std::function<void(const EyeImage&, const EyeView&)>& draw)
{
    Swapchain& swapchain = m_swapchains[eye];
    Acquired image(swapchain);
    std::optional<Acquired> depth;
    if (!m_depths.empty())
        depth.emplace(m_depths[eye]);
    const ImageSize& size = swapchain.size();
    draw({image.texture(), static_cast<unsigned int>(m_format.name), size.width, size.height,
          depth ? depth->texture() : 0, static_cast<unsigned int>(m_depthFormat.name)},
         viewOf(eye));
    image.release();
    if (depth)
        depth->release();
    m_pictures.push_back({XR_TYPE_COMPOSITION_LAYER_PROJECTION_VIEW,
                          depth ? &m_depthInfos[eye] : nullptr,
                          m_views[eye].pose,
                          m_views[eye].fov,
                          {swapchain.handle(), {{0, 0}, {size.width, size.height}}, 0}});
}

EyeView Views::viewOf(std::size_t eye) const
{
    const Pose pose = fromXr(m_views[eye].pose).inverse();
    EyeView view;
    view.width = m_swapchains[eye].size().width;
    view.height = m_swapchains[eye].size().height;
    view.isSrgb = m_format.isSrgb;
    view.hidden = &m_hidden.of(eye);
    view.projection = projectionOf(m_views[eye].fov, nearPlane, farPlane);
    view.view = Eigen::Isometry3f(pose.matrix().cast<float>().matrix());
    return view;
}
} // namespace vr
