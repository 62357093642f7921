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
    , m_hidden(instance, session)
    , m_images(makeImages(session, session.imageFormats()))
    , m_views(session.imageSizes().size(), unknownView)
{
    if (!session.depthFormats().empty())
        makeDepths(session);
}

/// Makes a swapchain for each eye, of the first format that the runtime does not refuse. Some runtimes offer formats of
/// which they make no images: SteamVR 2.9 for Linux refuses GL_RGBA8 and GL_RGBA16F.
Views::Images Views::makeImages(const Session& session, const std::vector<ImageFormat>& formats)
{
    std::optional<XrError> refusal;
    for (const ImageFormat& format : formats) {
        try {
            Images images{format, {}};
            for (const ImageSize& size : session.imageSizes())
                images.swapchains.emplace_back(session.handle(), format, size);
            return images;
        } catch (const XrError& error) {
            if (error.result() == XR_ERROR_INSTANCE_LOST || error.result() == XR_ERROR_SESSION_LOST)
                throw;
            qInfo("The OpenXR runtime makes no images of its OpenGL format 0x%llX: %s",
                  static_cast<long long>(format.name), qPrintable(error.text()));
            refusal = error;
        }
    }
    throw refusal.value_or(XrError("xrEnumerateSwapchainFormats", XR_ERROR_SWAPCHAIN_FORMAT_UNSUPPORTED));
}

/// Makes the depth images of each eye. A runtime that refuses all formats gets no depth.
void Views::makeDepths(const Session& session)
{
    try {
        m_depths = makeImages(session, session.depthFormats());
    } catch (const XrError& error) {
        qInfo("The OpenXR runtime takes no depth: %s", qPrintable(error.text()));
    }
    XrCompositionLayerDepthInfoKHR info{};
    info.type = XR_TYPE_COMPOSITION_LAYER_DEPTH_INFO_KHR;
    info.maxDepth = 1;
    info.nearZ = nearPlane;
    info.farZ = farPlane;
    for (const Swapchain& depth : m_depths.swapchains) {
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
    Swapchain& swapchain = m_images.swapchains[eye];
    Acquired image(swapchain);
    std::optional<Acquired> depth;
    if (!m_depths.swapchains.empty())
        depth.emplace(m_depths.swapchains[eye]);
    const ImageSize& size = swapchain.size();
    draw({image.texture(), static_cast<unsigned int>(m_images.format.name), size.width, size.height,
          depth ? depth->texture() : 0, static_cast<unsigned int>(m_depths.format.name)},
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
    view.width = m_images.swapchains[eye].size().width;
    view.height = m_images.swapchains[eye].size().height;
    view.isSrgb = m_images.format.isSrgb;
    view.hidden = &m_hidden.of(eye);
    view.projection = projectionOf(m_views[eye].fov, nearPlane, farPlane);
    view.view = Eigen::Isometry3f(pose.matrix().cast<float>().matrix());
    return view;
}
} // namespace vr
