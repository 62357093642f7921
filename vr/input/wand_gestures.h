#pragma once

#include "vr/input/trackpad_reader.h"

namespace vr
{
// Shares of the trigger's way. A Vive wand clicks at about 0.8, which is late.
inline constexpr double triggerPress = 0.55, triggerRelease = 0.45;
inline constexpr double minPressure = 0.05; ///< of a trigger that is down: a stroke does something
inline constexpr double holdSeconds = 0.8;  ///< for what must not happen by accident
/// Seconds. No frame counts as longer: what is held after a stall was perhaps let go meanwhile. Longer than a frame at
/// 5 Hz.
inline constexpr double maxFrameSeconds = 0.25;

/// A button in one frame.
struct ButtonGestures
{
    bool isDown = false;
    bool wentDown = false;
    bool wentUp = false;    ///< also when it is lost
    bool wasTapped = false; ///< let go before it was held for long
    double hold = 0;        ///< 0 to 1, which it stays at; falls to 0 when it is let go
    bool holdDone = false;  ///< in this frame, once a press
};

/// What a hand does with its wand in one frame.
struct WandGestures
{
    ButtonGestures trigger, menu, side; ///< the trigger is not held for long, whatever its hold says
    double pressure = 0;                ///< of the trigger: minPressure to 1 while it is down, else 0
    TrackpadGestures pad;
};

/// How long a frame counts.
class FrameClock
{
public:
    /// `time` in seconds. 0 to maxFrameSeconds; 0 for the first frame, and where time goes back.
    double step(double time);

private:
    std::optional<double> m_time;
};

/// Reads one button.
class ButtonReader
{
public:
    ButtonGestures read(bool isDown, double seconds);
    /// As TrackpadReader::ignoreUntilReleased().
    void ignoreUntilReleased();
    /// The press that goes on is neither held for long nor a tap.
    void cancelHold() { m_held.reset(); }

private:
    bool m_isIgnored = false;
    bool m_wasDown = false;
    std::optional<double> m_held; ///< seconds of a press
};

/// Reads one wand, frame by frame. The same motion gives the same gestures at 5 frames a second and at 144, as far as a
/// frame shows it at all. A wand that is not active lets everything go, and what is pressed when it comes back does
/// nothing until it has been let go. Squeezing a wand fires its side button: no hold runs while the trigger is down.
class GestureReader
{
public:
    /// `seconds`: since the frame before, by a FrameClock.
    WandGestures read(const WandState& wand, double seconds);
    /// What goes on ends, and what is pressed does nothing until it has been let go.
    void ignoreUntilReleased();
    /// As ignoreUntilReleased(), for all buttons except the trigger.
    void ignoreButtonsUntilReleased();

private:
    bool m_triggerIsDown = false;
    ButtonReader m_trigger, m_menu, m_side;
    TrackpadReader m_pad;
};
} // namespace vr
