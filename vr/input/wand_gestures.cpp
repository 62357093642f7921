#include "vr/input/wand_gestures.h"

#include <algorithm>
#include <utility>

namespace vr
{
namespace
{
constexpr double roundOff = 1e-9; ///< tolerance for rounding errors in sums of frame times, seconds

/// Returns the state of an inactive wand with all buttons down. Buttons that cannot be seen may be down, so each has to
/// be seen released before it counts.
WandState unseen(const WandState& wand)
{
    WandState state = wand;
    state.trigger = 1;
    state.padTouched = state.padPressed = state.side = state.menu = true;
    return state;
}

double pressureOf(double trigger)
{
    return std::clamp((trigger - triggerRelease) / (1 - triggerRelease), minPressure, 1.0);
}
} // namespace

double FrameClock::step(double time)
{
    const double before = std::exchange(m_time, time).value_or(time);
    return std::clamp(time - before, 0.0, maxFrameSeconds);
}

ButtonGestures ButtonReader::read(bool isDown, double seconds)
{
    m_isIgnored = m_isIgnored && isDown;
    ButtonGestures gestures;
    gestures.isDown = isDown && !m_isIgnored;
    const bool wasDown = std::exchange(m_wasDown, gestures.isDown);
    gestures.wentDown = gestures.isDown && !wasDown;
    gestures.wentUp = wasDown && !gestures.isDown;
    if (gestures.wentDown)
        m_held = 0;
    if (!m_held)
        return gestures;
    const bool wasDone = *m_held >= holdSeconds - roundOff;
    if (!gestures.isDown) {
        gestures.wasTapped = !wasDone;
        m_held.reset();
        return gestures;
    }
    if (wasDown)
        *m_held += seconds;
    const bool isDone = *m_held >= holdSeconds - roundOff;
    gestures.holdDone = isDone && !wasDone;
    gestures.hold = isDone ? 1 : *m_held / holdSeconds;
    return gestures;
}

void ButtonReader::ignoreUntilReleased()
{
    m_isIgnored = true;
    m_held.reset();
}

WandGestures GestureReader::read(const WandState& wand, double seconds)
{
    if (!wand.isActive)
        ignoreUntilReleased();
    const WandState state = wand.isActive ? wand : unseen(wand);
    m_triggerIsDown = state.trigger >= (m_triggerIsDown ? triggerRelease : triggerPress);
    WandGestures gestures;
    gestures.trigger = m_trigger.read(m_triggerIsDown, seconds);
    if (gestures.trigger.isDown) {
        gestures.pressure = pressureOf(state.trigger);
        m_menu.cancelHold();
        m_side.cancelHold();
    }
    gestures.menu = m_menu.read(state.menu, seconds);
    gestures.side = m_side.read(state.side, seconds);
    gestures.pad = m_pad.read(state, seconds);
    return gestures;
}

void GestureReader::ignoreUntilReleased()
{
    m_trigger.ignoreUntilReleased();
    ignoreButtonsUntilReleased();
}

void GestureReader::ignoreButtonsUntilReleased()
{
    m_menu.ignoreUntilReleased();
    m_side.ignoreUntilReleased();
    m_pad.ignoreUntilReleased();
}
} // namespace vr
