#include "ui/viewport/head_tracking.h"
#include "ui/viewport/viewport_state.h"

#include <chrono>
#include <cmath>

namespace ui
{
namespace
{
constexpr std::chrono::milliseconds followInterval(16); ///< a frame
constexpr double leastTurn = 1e-5;                      ///< radians, and of the distance: less is not seen

bool differ(const OrbitCamera::Pose& a, const OrbitCamera::Pose& b)
{
    return (a.target - b.target).norm() + std::abs(a.distance - b.distance) > leastTurn * a.distance ||
           std::abs(a.yaw - b.yaw) > leastTurn || std::abs(a.pitch - b.pitch) > leastTurn;
}
} // namespace

void Viewport::State::placeWearer()
{
    std::optional<Wearer> shown = wearer;
    if (shown && following.isActive())
        shown->head.reset();
    scene->showWearer(shown);
    scene->showTeacher(teacher);
}

void Viewport::prepareFollowing()
{
    m_state->following.setTimerType(Qt::PreciseTimer);
    m_state->following.setInterval(followInterval);
    connect(&m_state->following, &QTimer::timeout, this, &Viewport::follow);
    connect(&m_state->input, &PointerInput::viewTaken, this, [this] { setFollowing(false); });
}

void Viewport::showWearer(const std::optional<Wearer>& wearer)
{
    if (!wearer && !m_state->wearer)
        return;
    m_state->wearer = wearer;
    if (!wearer)
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
    if (on == isFollowing() || (on && !m_state->wearer))
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
    if (!s.wearer->head || s.input.strokeOpen() || s.input.pressWaits())
        return;
    const OrbitCamera::Pose pose = followed(s.camera, *s.wearer->head, seconds);
    if (!differ(s.camera.pose(), pose))
        return;
    s.camera.setPose(pose);
    s.input.viewMoved();
}
} // namespace ui
