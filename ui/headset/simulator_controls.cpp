#include "ui/headset/simulator_controls.h"

#include <algorithm>

namespace ui
{
namespace
{
using core::Vec3;
using Eigen::AngleAxisd;
using Eigen::Isometry3d;

// Metres and radians.
constexpr double maxOffset = 3, minEyeHeight = 0.3, maxEyeHeight = 2.5;
constexpr double steepest = 1.4;
constexpr double minReach = 0.15, maxReach = 2;
/// The right one, as seen from the eyes: a wand comes from there, out of the view's way.
const Vec3 wrist{0.14, -0.24, 0.08};
const Vec3 restPosition{0.26, -0.34,
                        -0.42};   ///< the right one's tip, as seen from the eyes of a head that looks straight
constexpr double restPitch = 0.3; ///< a wand at rest points so far up

double sideOf(SimulatedHand hand)
{
    return hand == SimulatedHand::Left ? -1 : 1;
}

Vec3 mirrored(const Vec3& right, SimulatedHand hand)
{
    return {sideOf(hand) * right.x(), right.y(), right.z()};
}

/// At that place, and its -Z from there to it. Upright as far as it can be.
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

/// As seen from the body.
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

Isometry3d SimulatorControls::atMouse() const
{
    const Vec3 way = Vec3(m_place.x() * sideTangent, m_place.y() * upTangent, -1).normalized();
    return head() * pointing(mirrored(wrist, m_hand), m_reach * way) * AngleAxisd(m_turn, Vec3::UnitZ());
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

void SimulatorControls::reach(double metres)
{
    m_reach = std::clamp(m_reach + metres, minReach, maxReach);
}
} // namespace ui
