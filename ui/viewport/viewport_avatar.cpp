#include "ui/viewport/head_tracking.h"
#include "ui/viewport/viewport_state.h"

#include <chrono>
#include <cmath>

namespace ui
{
namespace
{
constexpr std::chrono::milliseconds followInterval(16); ///< a frame
constexpr double minPoseChange = 1e-5;                  ///< radians, and of the distance: less is not seen

bool differ(const OrbitCamera::Pose& a, const OrbitCamera::Pose& b)
{
    return (a.target - b.target).norm() + std::abs(a.distance - b.distance) > minPoseChange * a.distance ||
           std::abs(a.yaw - b.yaw) > minPoseChange || std::abs(a.pitch - b.pitch) > minPoseChange;
}
} // namespace

void Viewport::State::placeAvatar()
{
    std::optional<HeadsetAvatar> shown = avatar;
    if (shown && following.isActive())
        shown->head.reset();
    scene->showAvatar(shown);
    scene->showTeacher(teacher);
}

void Viewport::prepareFollowing()
{
    m_state->following.setTimerType(Qt::PreciseTimer);
    m_state->following.setInterval(followInterval);
    connect(&m_state->following, &QTimer::timeout, this, &Viewport::follow);
    connect(&m_state->input, &PointerInput::viewMovedByUser, this, [this] { setFollowing(false); });
}

void Viewport::showAvatar(const std::optional<HeadsetAvatar>& avatar)
{
    if (!avatar && !m_state->avatar)
        return;
    m_state->avatar = avatar;
    if (!avatar)
        setFollowing(false);
    update();
}

void Viewport::showTeacher(const std::optional<core::Sphere>& brush)
{
    if (!brush && !m_state->teacher)
        return;
    m_state->teacher = brush;
    update();
    Q_EMIT teacherShown(brush);
}

void Viewport::setFollowing(bool on)
{
    if (on == isFollowing() || (on && !m_state->avatar))
        return;
    m_state->flight.stop();
    m_state->sinceFollowed.start();
    on ? m_state->following.start() : m_state->following.stop();
    update();
    Q_EMIT followingChanged(on);
}

bool Viewport::isFollowing() const
{
    return m_state->following.isActive();
}

/// A stroke of the mouse holds the view still.
void Viewport::follow()
{
    State& s = *m_state;
    const double seconds = static_cast<double>(s.sinceFollowed.nsecsElapsed()) * 1e-9;
    s.sinceFollowed.start();
    if (!s.avatar->head || s.input.strokeOpen() || s.input.isPressPending())
        return;
    const OrbitCamera::Pose pose = headTrackingStep(s.camera, *s.avatar->head, seconds);
    if (!differ(s.camera.pose(), pose))
        return;
    s.camera.setPose(pose);
    s.input.viewMoved();
}
} // namespace ui
