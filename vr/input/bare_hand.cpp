#include "vr/input/bare_hand.h"

#include <cmath>
#include <numbers>

namespace vr
{
namespace
{
constexpr double shownRoundOff = 1e-9; ///< tolerance for rounding errors in sums of frame times, seconds

double cosineOf(double degrees)
{
    return std::cos(degrees * std::numbers::pi / 180);
}

/// Returns the direction out of the palm, of length 1. OpenXR's grip pose has its X axis out of the left palm and into
/// the right one.
core::Vec3 palmNormal(const Pose& grip, Side side)
{
    return grip.rotation * core::Vec3(side == Side::Left ? 1 : -1, 0, 0);
}
} // namespace

WandState BareHandReader::read(const WandState& hand, const Pose& head, double time)
{
    const double seconds = m_clock.step(time);
    if (!hand.isHand || !hand.isActive) {
        m_held = Held::None;
        m_showsPalm = false;
        m_shownFor = 0;
        return hand;
    }
    hold(hand);
    m_showsPalm = isPalmShown(hand, head);
    m_shownFor = m_showsPalm ? m_shownFor + seconds : 0;
    WandState wand = hand;
    const bool mayPinch = m_held == Held::Pinch || (m_held == Held::None && hand.squeeze < fistBlocksPinch);
    wand.trigger = mayPinch ? hand.trigger : 0;
    wand.side = m_held == Held::Fist && hand.side;
    wand.menu = m_shownFor >= palmSeconds - shownRoundOff;
    return wand;
}

void BareHandReader::hold(const WandState& hand)
{
    if (m_held == Held::Pinch && hand.trigger < triggerRelease)
        m_held = Held::None;
    else if (m_held == Held::Fist && !hand.side && hand.trigger < triggerRelease)
        m_held = Held::None;
    if (m_held != Held::None)
        return;
    if (hand.side)
        m_held = Held::Fist;
    else if (hand.trigger >= triggerPress && hand.squeeze < fistBlocksPinch)
        m_held = Held::Pinch;
}

/// Returns whether the open palm is turned to the face of a user who looks at it.
bool BareHandReader::isPalmShown(const WandState& hand, const Pose& head) const
{
    const bool isOpen = hand.trigger < openHand && hand.squeeze < openHand;
    const core::Vec3 toHead = (head.position - hand.grip.position).normalized();
    const double turned = palmNormal(hand.grip, m_side).dot(toHead);
    const bool isLookedAt = -head.forward().dot(toHead) > cosineOf(palmLookAngle);
    return hand.isTracked && isOpen && isLookedAt && turned > cosineOf(m_showsPalm ? palmAwayAngle : palmAngle);
}
} // namespace vr
