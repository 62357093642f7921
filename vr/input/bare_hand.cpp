#include "vr/input/bare_hand.h"

#include "vr/input/wand_mapping.h"

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
    if (!hand.isHand) {
        forget();
        hidePalm();
        return hand;
    }
    readPalm(hand, head, seconds);
    if (!hand.isActive)
        return lost(hand);
    hold(hand);
    WandState wand = hand;
    const bool mayPinch = m_held == Held::Pinch || (m_held == Held::None && hand.squeeze < fistBlocksPinch);
    wand.trigger = mayPinch ? hand.trigger : 0;
    wand.side = m_held == Held::Fist && hand.side;
    wand.menu = isPalmPressed();
    m_last = wand;
    return wand;
}

/// Returns a hand of which the runtime reports no gestures: as it was before for up to maxTrackingGap, then without
/// any.
WandState BareHandReader::lost(const WandState& hand)
{
    if (m_unseenFor > maxTrackingGap)
        forget();
    if (!m_last)
        return hand;
    WandState wand = *m_last;
    wand.grip = hand.grip;
    wand.aim = hand.aim;
    wand.pinch = hand.pinch;
    wand.isTracked = false;
    return wand;
}

void BareHandReader::forget()
{
    m_held = Held::None;
    m_last.reset();
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

void BareHandReader::readPalm(const WandState& hand, const Pose& head, double seconds)
{
    const bool isSeen = hand.isActive && hand.isTracked;
    m_unseenFor = isSeen ? 0 : m_unseenFor + seconds;
    if (m_unseenFor > maxPalmGap || (isSeen && !isPalmShown(hand, head)))
        hidePalm();
    else if (isSeen)
        m_shownFor = m_shownFor ? *m_shownFor + seconds : 0;
}

/// Returns whether the palm is turned to the face. Until it counts, the hand must be open, and the user must look at
/// it.
bool BareHandReader::isPalmShown(const WandState& hand, const Pose& head) const
{
    const core::Vec3 toHead = (head.position - hand.grip.position).normalized();
    const double turned = palmNormal(hand.grip, m_side).dot(toHead);
    const bool isOpen = hand.trigger < openHand && hand.squeeze < openHand;
    const bool isLookedAt = -head.forward().dot(toHead) > cosineOf(palmLookAngle);
    return turned > cosineOf(m_shownFor ? palmAwayAngle : palmAngle) && (isPalmPressed() || (isOpen && isLookedAt));
}

bool BareHandReader::isPalmPressed() const
{
    return m_shownFor && *m_shownFor >= palmSeconds - shownRoundOff;
}
} // namespace vr
