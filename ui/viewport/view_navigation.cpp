#include "ui/viewport/view_navigation.h"

#include "ui/viewport/head_tracking.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace ui
{
namespace
{
constexpr int flightMs = 350;
constexpr double minPlaceShare = 0.04; ///< smallest size of a place, as a fraction of the model's longest side
constexpr std::chrono::milliseconds followInterval(16); ///< about one frame
/// smallest visible change of a pose: of angles in radians, of positions as a fraction of the distance to the target
constexpr double minPoseChange = 1e-5;

bool differ(const OrbitCamera::Pose& a, const OrbitCamera::Pose& b)
{
    return (a.target - b.target).norm() + std::abs(a.distance - b.distance) > minPoseChange * a.distance ||
           std::abs(a.yaw - b.yaw) > minPoseChange || std::abs(a.pitch - b.pitch) > minPoseChange;
}
} // namespace

ViewNavigation::ViewNavigation(OrbitCamera* camera, PointerInput* input, QObject* parent)
    : QObject(parent)
    , m_camera(camera)
    , m_input(input)
{
    m_flight.setStartValue(0.0);
    m_flight.setEndValue(1.0);
    m_flight.setDuration(flightMs);
    m_flight.setEasingCurve(QEasingCurve::InOutCubic);
    connect(&m_flight, &QVariantAnimation::valueChanged, this, [this](const QVariant& share) {
        m_camera->setPose(OrbitCamera::between(m_from, m_to, share.toDouble()));
        m_input->viewMoved();
    });
    m_following.setTimerType(Qt::PreciseTimer);
    m_following.setInterval(followInterval);
    connect(&m_following, &QTimer::timeout, this, &ViewNavigation::follow);
    connect(input, &PointerInput::viewMovedByUser, this, [this] { setFollowing(false); });
}

void ViewNavigation::showModel(const core::Box& box)
{
    m_box = box;
    stop();
    clearMark();
    m_camera->setPivot({});
    m_camera->turnToFirst();
    m_camera->frame(box);
    m_input->viewMoved();
}

void ViewNavigation::setBox(const core::Box& box)
{
    m_box = box;
    m_camera->setScene(box);
}

void ViewNavigation::frame()
{
    setFollowing(false);
    m_camera->frame(m_box);
    m_input->viewMoved();
}

void ViewNavigation::turnTo(OrbitCamera::Side side)
{
    setFollowing(false);
    m_camera->turnTo(side);
    m_input->viewMoved();
}

void ViewNavigation::setView(const core::SavedView& view)
{
    m_camera->setView(view);
    m_input->viewMoved();
}

void ViewNavigation::setProjection(OrbitCamera::Projection projection)
{
    m_camera->setProjection(projection);
    m_input->viewMoved();
}

void ViewNavigation::turn(double right, double down)
{
    stop();
    const double perDegree = m_camera->viewport().y() / 180;
    m_input->orbit(perDegree * OrbitCamera::Pixel(right, down));
}

void ViewNavigation::zoom(double factor, const std::optional<OrbitCamera::Pixel>& toward)
{
    stop();
    m_input->zoom(factor, toward ? *toward : OrbitCamera::Pixel(0.5 * m_camera->viewport()));
}

void ViewNavigation::turnModel(double angle, double seconds)
{
    if (!isFollowing() || m_input->strokeOpen())
        m_input->turnModel(angle, seconds);
}

void ViewNavigation::flyTo(const core::Vec3& point, const core::Vec3& normal, double extent)
{
    setFollowing(false);
    stop();
    const double size = m_box.isEmpty() ? extent : m_box.sizes().maxCoeff();
    const double shown = std::clamp(extent, minPlaceShare * size, size);
    m_mark = Mark{point, normal, 0.5 * shown};
    fly(m_camera->facing(point, normal, shown));
}

void ViewNavigation::flyTo(const core::Box& box, double yaw, double pitch)
{
    setFollowing(false);
    stop();
    OrbitCamera there = *m_camera;
    OrbitCamera::Pose pose = there.pose();
    pose.yaw = yaw;
    pose.pitch = pitch;
    there.setPose(pose);
    there.frame(box);
    fly(there.pose());
}

void ViewNavigation::fly(const OrbitCamera::Pose& to)
{
    m_camera->setPivot({});
    m_from = m_camera->pose();
    m_to = to;
    if (!m_reducesMotion)
        return m_flight.start();
    m_camera->setPose(m_to);
    m_input->viewMoved();
}

void ViewNavigation::clearMark()
{
    if (m_mark)
        stop();
    m_mark.reset();
    Q_EMIT markChanged();
}

void ViewNavigation::setAvatar(const std::optional<HeadsetAvatar>& avatar)
{
    m_avatar = avatar;
    if (!avatar)
        setFollowing(false);
}

std::optional<HeadsetAvatar> ViewNavigation::shownAvatar() const
{
    std::optional<HeadsetAvatar> shown = m_avatar;
    if (shown && isFollowing())
        shown->head.reset();
    return shown;
}

void ViewNavigation::setFollowing(bool on)
{
    if (on == isFollowing() || (on && !m_avatar))
        return;
    stop();
    m_sinceFollowed.start();
    on ? m_following.start() : m_following.stop();
    Q_EMIT followingChanged(on);
}

/// Moves the view one step towards the head, unless a stroke with the mouse is in progress.
void ViewNavigation::follow()
{
    const double seconds = static_cast<double>(m_sinceFollowed.nsecsElapsed()) * 1e-9;
    m_sinceFollowed.start();
    if (!m_avatar->head || m_input->strokeOpen() || m_input->isPressPending())
        return;
    const OrbitCamera::Pose pose = headTrackingStep(*m_camera, *m_avatar->head, seconds);
    if (!differ(m_camera->pose(), pose))
        return;
    m_camera->setPose(pose);
    m_input->viewMoved();
}
} // namespace ui
