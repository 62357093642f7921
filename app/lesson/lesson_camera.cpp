#include "app/lesson/lesson_camera.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace app
{
namespace
{
constexpr double degree = std::numbers::pi / 180;
/// smallest and largest pitch to which follow() turns the view, radians
constexpr double lowest = -30 * degree, highest = 60 * degree;
constexpr double border = 0.05; ///< share of the view's width and height at each edge; a brush there counts as hidden
/// the brush counts as hidden if its depth behind the model's centre exceeds this share of its distance from the centre
constexpr double behind = 0.3;
constexpr int betweenFlights = 800; ///< shortest time between two camera movements, ms

/// Returns the box of the model and of the demonstration's brushes. Brushes placed by a ray are on the model itself.
core::Box reachOf(const core::LessonStep& step, core::Box box)
{
    for (const core::FileEntry& entry : step.strokes)
        if (const auto* const stroke = std::get_if<core::Stroke>(&entry); stroke && !core::isByRay(stroke->settings))
            for (const core::StrokeSample& sample : stroke->samples)
                box.extend(core::Vec3(sample.rotation.conjugate() * sample.position));
    return box;
}

double angleOf(const Eigen::Quaterniond& rotation)
{
    return 2 * std::atan2(rotation.y(), rotation.w());
}
} // namespace

void LessonCamera::show(const core::LessonStep& step)
{
    if (!m_viewport)
        return;
    ui::ViewNavigation* const navigation = m_viewport->navigation();
    const ui::OrbitCamera::Pose now = m_viewport->camera().pose();
    navigation->flyTo(reachOf(step, navigation->box()), step.view ? step.view->yaw * degree : now.yaw,
                      step.view ? step.view->pitch * degree : now.pitch);
    m_sinceFlight.start();
}

bool LessonCamera::isInSight(const core::Sphere& shown) const
{
    const ui::OrbitCamera& camera = m_viewport->camera();
    const ui::OrbitCamera::Pixel at = camera.project(shown.center), size = camera.viewport();
    const core::Vec3 outward = shown.center - m_viewport->navigation()->box().center();
    return at.x() > border * size.x() && at.x() < (1 - border) * size.x() && at.y() > border * size.y() &&
           at.y() < (1 - border) * size.y() && outward.dot(camera.viewDirection()) < behind * outward.norm();
}

/// Turns the view together with the turntable, so that the brush stands still in the picture. Otherwise moves the
/// camera to the brush if it is hidden.
void LessonCamera::follow(const core::GhostBrush& ghost, const core::Sphere& shown)
{
    if (!m_viewport)
        return;
    const double turned = angleOf(ghost.rotation);
    const double by = std::remainder(turned - m_turned.value_or(turned), 2 * std::numbers::pi);
    m_turned = turned;
    ui::ViewNavigation* const navigation = m_viewport->navigation();
    if (std::abs(by) > 0)
        return navigation->turnModel(by, 0);
    if (isInSight(shown) || (m_sinceFlight.isValid() && !m_sinceFlight.hasExpired(betweenFlights)))
        return;
    const core::Vec3 outward = shown.center - navigation->box().center();
    core::Box box = navigation->box();
    box.extend(shown.center);
    navigation->flyTo(box, std::atan2(outward.x(), outward.z()),
                      std::clamp(std::atan2(outward.y(), std::hypot(outward.x(), outward.z())), lowest, highest));
    m_sinceFlight.start();
}
} // namespace app
