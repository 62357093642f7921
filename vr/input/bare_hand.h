#pragma once

#include "vr/input/wand_gestures.h"

namespace vr
{
/// Closure of the other fingers, 0 to 1, from which on a new pinch does not count: the hand is about to make a fist.
inline constexpr double fistBlocksPinch = 0.35;
/// A hand that begins to show its palm is open: pinch and fist are below this, 0 to 1.
inline constexpr double openHand = 0.3;
/// Angle between the palm's normal and the direction to the head, degrees. Below the first the palm is turned to the
/// face, until it is above the second.
inline constexpr double palmAngle = 35, palmAwayAngle = 50;
/// Largest angle between the direction of view and a hand that begins to show its palm, degrees.
inline constexpr double palmLookAngle = 35;
/// Seconds for which a palm is shown before it counts as the press of a menu button.
inline constexpr double palmSeconds = 0.25;
/// Longest time that a palm counts as shown while the hand is not tracked, seconds.
inline constexpr double maxPalmGap = 0.5;

/// Reads the gestures of a bare hand as those of a wand: a pinch as the trigger, a fist as the side button, and a palm
/// turned to the face as the menu button.
///
/// A fist brings finger and thumb together too, and a pinch may curl the other fingers. Of the two, the one that began
/// first counts until both have ended. A palm counts once, until it is turned away: a hand that closes, a glance aside
/// and a moment without tracking do not press again. A hand whose gestures are lost holds on for maxTrackingGap, as the
/// stroke of an untracked wand does, because a hand often hides its own fingers. The only clock is the frames' times.
class BareHandReader
{
public:
    explicit BareHandReader(Side side = Side::Right) : m_side(side) {}

    /// Returns the hand as a wand. A wand is returned unchanged. Units: `time` in seconds.
    WandState read(const WandState& hand, const Pose& head, double time);

private:
    enum class Held { None, Pinch, Fist };

    WandState lost(const WandState& hand);
    void forget();
    void hold(const WandState& hand);
    void readPalm(const WandState& hand, const Pose& head, double seconds);
    void hidePalm() { m_shownFor.reset(); }
    bool isPalmShown(const WandState& hand, const Pose& head) const;
    bool isPalmPressed() const;

    Side m_side;
    FrameClock m_clock;
    Held m_held = Held::None;
    std::optional<WandState> m_last;  ///< the hand as a wand in the last frame in which it was active; none: it is lost
    std::optional<double> m_shownFor; ///< seconds that the palm has been turned to the face; none: it is not
    double m_unseenFor = 0;           ///< seconds that the hand has not been tracked
};
} // namespace vr
