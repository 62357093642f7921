#pragma once

#include "ui/input/pointer_input.h"

class QTouchEvent;

namespace ui
{
/// One finger is the left button, two move the view: pinching zooms, dragging pans. A finger counts as pressed when it
/// has moved a little or is lifted, so that a second one that comes late leaves no dab. Thread: gui.
class TouchInput
{
public:
    /// Not owned.
    explicit TouchInput(PointerInput* input) : m_input(input) {}

    void handle(const QTouchEvent& event);

private:
    /// The two that move the view.
    struct Fingers
    {
        int idA = -1, idB = -1;
        OrbitCamera::Pixel a{0, 0}, b{0, 0};
    };

    void oneFinger(const QTouchEvent& event);
    void twoFingers(const QTouchEvent& event);
    void send(PointerEvent::Kind kind, const OrbitCamera::Pixel& pixel, const QTouchEvent& event);

    PointerInput* m_input;
    bool m_pressed = false; ///< the one finger, as a left button
    bool m_gesture = false; ///< there were two fingers since the first came
    Fingers m_fingers;
    OrbitCamera::Pixel m_start{0, 0}; ///< of the one finger
};
} // namespace ui
