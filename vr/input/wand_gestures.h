#pragma once

#include "vr/input/trackpad_reader.h"

namespace vr
{
// Thresholds as fractions of the trigger's travel. A Vive wand clicks only at about 0.8, which is late.
inline constexpr double triggerPress = 0.55, triggerRelease = 0.45;
/// Least pressure of a pulled trigger, 0 to 1: every stroke has some effect.
inline constexpr double minPressure = 0.05;
/// Seconds that a button is held for functions that must not happen by accident.
inline constexpr double holdSeconds = 0.8;
/// Longest duration that is counted for a frame, seconds. A button that was held before a stall may have been released
/// during it. The limit is longer than a frame at 5 Hz.
inline constexpr double maxFrameSeconds = 0.25;

/// State of a button in one frame.
struct ButtonGestures
{
    bool isDown = false;
    bool wentDown = false;
    bool wentUp = false;    ///< the button was released, or the wand was lost
    bool wasTapped = false; ///< released before the hold was complete
    double hold = 0;        ///< progress of a hold, 0 to 1; it stays at 1, and is 0 after the release
    bool holdDone = false;  ///< the hold was completed in this frame; true once for each press
};

/// Gestures of one wand in one frame.
struct WandGestures
{
    ButtonGestures trigger, menu, side; ///< the hold members of the trigger are not used
    double pressure = 0;                ///< pressure of the trigger: minPressure to 1 while it is down, else 0
    TrackpadGestures pad;
};

/// Measures the duration of frames.
class FrameClock
{
public:
    /// Returns the seconds since the last frame, 0 to maxFrameSeconds. Returns 0 for the first frame, and if time goes
    /// back. Units: `time` in seconds.
    double step(double time);

private:
    std::optional<double> m_time;
};

/// Reads one button.
class ButtonReader
{
public:
    ButtonGestures read(bool isDown, double seconds);
    /// Ends a press in progress. The button has no effect until it was released.
    void ignoreUntilReleased();
    /// Cancels the hold of the present press, which is no tap either.
    void cancelHold() { m_held.reset(); }

private:
    bool m_isIgnored = false;
    bool m_wasDown = false;
    std::optional<double> m_held; ///< seconds since the press began; none: no press, or its hold was cancelled
};

/// Reads one wand, frame by frame. The same movement gives the same gestures at 5 frames a second as at 144, except for
/// changes that last less than a frame. An inactive wand counts as released; a button that is down when the wand
/// returns has no effect until it was released. Pulling the trigger may press the side button by accident, so no hold
/// runs while the trigger is down.
class GestureReader
{
public:
    /// Returns the gestures of a frame. `seconds`: time since the last frame, by a FrameClock.
    WandGestures read(const WandState& wand, double seconds);
    /// Ends gestures in progress. Buttons that are down have no effect until they were released.
    void ignoreUntilReleased();
    /// Ends gestures in progress, except those of the trigger. Buttons that are down have no effect until they were
    /// released.
    void ignoreButtonsUntilReleased();

private:
    bool m_triggerIsDown = false;
    ButtonReader m_trigger, m_menu, m_side;
    TrackpadReader m_pad;
};
} // namespace vr
