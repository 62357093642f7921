#include "app/headset/simulator_gaze.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace app
{
namespace
{
constexpr double turnSpeed = 2.5; ///< radians per second
constexpr double edge = 0.04;     ///< margin between a panel and the edge of the view, radians
constexpr double enough = 0.005;  ///< turning ends when a smaller angle than this is missing, radians

/// Returns whether the user opens this kind of panel; others appear beside the work automatically.
bool isOpenedByHand(vr::PanelKind kind)
{
    using enum vr::PanelKind;
    return kind == Tools || kind == Color || kind == Files || kind == Settings || kind == Parts;
}
} // namespace

void SimulatorGaze::cancel()
{
    m_turned = 0;
    m_isDone = true;
}

/// Returns the angle by which the head must turn to see the whole panel, radians; positive: left, negative: right.
double SimulatorGaze::missing(const vr::PanelTarget& panel, const vr::Pose& head, double sideTangent)
{
    const double most = std::atan(sideTangent) - edge;
    double left = -std::numeric_limits<double>::infinity(), right = -left;
    for (const double x : {-0.5, 0.5})
        for (const double y : {-0.5, 0.5}) {
            const core::Vec3 way = panel.pose * core::Vec3(x * panel.size.x(), y * panel.size.y(), 0) - head.position;
            const core::Vec3 forward = head.forward();
            const double at = std::atan2(-way.x(), -way.z()) - std::atan2(-forward.x(), -forward.z());
            left = std::max(left, std::remainder(at, 2 * std::numbers::pi));
            right = std::min(right, std::remainder(at, 2 * std::numbers::pi));
        }
    const double tooFarLeft = left - most, tooFarRight = -most - right;
    return tooFarLeft > 0 ? tooFarLeft : tooFarRight > 0 ? -tooFarRight : 0;
}

double SimulatorGaze::step(std::span<const vr::PanelTarget> panels, const vr::Pose& head, double sideTangent,
                           double seconds)
{
    Kinds open;
    for (const vr::PanelTarget& panel : panels)
        if (isOpenedByHand(panel.kind))
            open.set(static_cast<std::size_t>(panel.kind));
    const Kinds before = std::exchange(m_open, open), opened = open & ~before;
    const auto shown = std::ranges::find_if(panels, [&](const vr::PanelTarget& panel) {
        return opened.any() ? opened.test(static_cast<std::size_t>(panel.kind)) : panel.kind == m_panel;
    });
    const std::optional<vr::PanelKind> now = shown == panels.end() ? std::nullopt : std::optional(shown->kind);
    if (std::exchange(m_panel, now) != now || (open.none() && before.any()))
        m_isDone = !now && open.any(); // another open panel is not looked at automatically
    if (m_isDone)
        return 0;
    const double wanted = now ? missing(*shown, head, sideTangent) : -m_turned;
    const double most = seconds > 0 ? turnSpeed * seconds : std::abs(wanted);
    const double turn = std::clamp(wanted, -most, most);
    m_turned += turn;
    m_isDone = std::abs(wanted) < enough;
    return turn;
}
} // namespace app
