#include "ui/headset/simulator_controls.h"

#include <algorithm>
#include <utility>

namespace ui
{
namespace
{
using core::Vec3;
using Eigen::AngleAxisd;
using Eigen::Isometry3d;

// Units: metres and radians.
constexpr double maxOffset = 3, minEyeHeight = 0.3, maxEyeHeight = 2.5;
constexpr double steepest = 1.4;
constexpr double minReach = 0.15, maxReach = 2;
constexpr double standOff = 0.15; ///< metres from the tip of a pointing wand to the place it points at
/// The right wrist in head space; the wand extends from the wrist without covering the view.
const Vec3 wrist{0.14, -0.24, 0.08};
/// The tip of the resting right wand in head space, for a level head. It is far enough ahead that a panel above it is
/// fully visible.
const Vec3 restPosition{0.12, -0.4, -0.5};
constexpr double restPitch = 0.3; ///< pitch of a resting wand, radians upwards

double sideOf(SimulatedHand hand)
{
    return hand == SimulatedHand::Left ? -1 : 1;
}

Vec3 mirrored(const Vec3& right, SimulatedHand hand)
{
    return {sideOf(hand) * right.x(), right.y(), right.z()};
}

/// Returns a pose at `to` whose -Z axis points from `from` to `to`, with Y as upright as possible.
Isometry3d pointing(const Vec3& from, const Vec3& to)
{
    Eigen::Matrix3d axes;
    axes.col(2) = (from - to).normalized();
    axes.col(0) = Vec3::UnitY().cross(axes.col(2)).normalized();
    axes.col(1) = axes.col(2).cross(axes.col(0));
    Isometry3d pose(axes);
    pose.translation() = to;
    return pose;
}

/// Returns the pose of the resting wand in body space.
Isometry3d restPose(SimulatedHand hand)
{
    return Eigen::Translation3d(mirrored(restPosition, hand)) * AngleAxisd(restPitch, Vec3::UnitX());
}

bool holds(const SimulatedButtons& buttons)
{
    return buttons.trigger > 0 || buttons.squeezes;
}
} // namespace

SimulatorControls::SimulatorControls() : m_restingWand(restPose(SimulatedHand::Left)) {}

Isometry3d SimulatorControls::body() const
{
    return Eigen::Translation3d(m_position) * AngleAxisd(m_yaw, Vec3::UnitY());
}

Isometry3d SimulatorControls::head() const
{
    return body() * AngleAxisd(m_pitch, Vec3::UnitX());
}

/// Returns the direction through the mouse in head space, a unit vector.
Vec3 SimulatorControls::way() const
{
    return Vec3(m_place.x() * sideTangent, m_place.y() * upTangent, -1).normalized();
}

core::Ray SimulatorControls::sight() const
{
    return {head().translation(), head().linear() * way()};
}

Isometry3d SimulatorControls::atMouse() const
{
    const Vec3 from = mirrored(wrist, m_hand), place = m_reach * way();
    const double afar = m_pointsFromAfar ? std::min(standOff, (place - from).norm() / 2) : 0;
    return head() * pointing(from, place) * Eigen::Translation3d(0, 0, afar) * AngleAxisd(m_turn, Vec3::UnitZ());
}

Isometry3d SimulatorControls::tip(SimulatedHand hand) const
{
    return hand == m_hand ? atMouse() : body() * m_restingWand;
}

void SimulatorControls::swapHands()
{
    m_restingWand = holds(buttons(m_hand)) ? Isometry3d(body().inverse() * atMouse()) : restPose(m_hand);
    m_hand = m_hand == SimulatedHand::Left ? SimulatedHand::Right : SimulatedHand::Left;
}

void SimulatorControls::turnHead(double left, double up)
{
    m_yaw += left;
    m_pitch = std::clamp(m_pitch + up, -steepest, steepest);
}

void SimulatorControls::walk(const Vec3& metres)
{
    m_position += body().linear() * metres;
    m_position = m_position.cwiseMax(Vec3(-maxOffset, minEyeHeight, -maxOffset))
                     .cwiseMin(Vec3(maxOffset, maxEyeHeight, maxOffset));
}

void SimulatorControls::pointAt(const Eigen::Vector2d& place)
{
    m_place = place.cwiseMax(-1).cwiseMin(1);
}

void SimulatorControls::meet(const std::optional<Surface>& surface, Following following, bool isRay)
{
    const Vec3 way = sight().direction;
    const double moved = m_reach * (way - std::exchange(m_lastWay, way)).norm();
    const bool presses = following == Following::WithTheMouse;
    const bool hasLeft = presses && surface && m_surface && surface->isPanel != m_surface->isPanel;
    if (following == Following::Not || hasLeft)
        return;
    m_surface = surface;
    if (!presses)
        m_pointsFromAfar = isRay || (surface && surface->isPanel);
    if (!surface)
        return;
    const double offset = m_pointsFromAfar ? 0 : m_offset;
    const double by = std::clamp(surface->distance + offset, minReach, maxReach) - m_reach;
    m_reach += following == Following::Freely ? by : std::clamp(by, -moved, moved);
}

void SimulatorControls::reach(double metres)
{
    const double before = std::exchange(m_reach, std::clamp(m_reach + metres, minReach, maxReach));
    if (m_surface && !m_pointsFromAfar)
        m_offset += m_reach - before;
}

std::optional<double> SimulatorControls::depth() const
{
    return m_surface && !m_pointsFromAfar ? std::optional(m_reach - m_surface->distance) : std::nullopt;
}
} // namespace ui
