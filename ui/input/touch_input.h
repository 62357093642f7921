#pragma once

#include "ui/input/pointer_input.h"

class QTouchEvent;

namespace ui
{
/// Touch input: one finger acts as the left button, two fingers move the view (pinching zooms, dragging pans). A finger
/// counts as pressed after a small motion or when lifted, so that a second finger that touches later leaves no dab.
/// Thread: gui.
class TouchInput
{
public:
    /// `input` is not owned.
    explicit TouchInput(PointerInput* input) : m_input(input) {}

    void handle(const QTouchEvent& event);

private:
    /// The two fingers of a gesture.
    struct Fingers
    {
        int idA = -1, idB = -1;
        OrbitCamera::Pixel a{0, 0}, b{0, 0};
    };

    void oneFinger(const QTouchEvent& event);
    void twoFingers(const QTouchEvent& event);
    void send(PointerEvent::Kind kind, const OrbitCamera::Pixel& pixel, const QTouchEvent& event);

    PointerInput* m_input;
    bool m_pressed = false; ///< the single finger acts as a pressed left button
    bool m_gesture = false; ///< two fingers have touched since the first one did
    Fingers m_fingers;
    OrbitCamera::Pixel m_start{0, 0}; ///< first position of the single finger
};
} // namespace ui
