#include "ui/input/touch_input.h"

#include <QGuiApplication>
#include <QStyleHints>
#include <QTouchEvent>

#include <algorithm>

namespace ui
{
namespace
{
using Pixel = OrbitCamera::Pixel;

constexpr double minDistance = 8; ///< logical pixels; fingers closer together do not zoom

Pixel pixelOf(const QPointF& position)
{
    return {position.x(), position.y()};
}
} // namespace

void TouchInput::handle(const QTouchEvent& event)
{
    if (event.type() == QEvent::TouchBegin)
        m_pressed = m_gesture = false;
    if (event.type() == QEvent::TouchCancel) {
        m_input->finish();
        m_input->pointerLeft();
    } else if (event.pointCount() >= 2) {
        twoFingers(event);
    } else if (event.pointCount() == 1 && !m_gesture) {
        oneFinger(event);
    }
    if (event.type() == QEvent::TouchEnd)
        m_input->pointerLeft();
}

void TouchInput::oneFinger(const QTouchEvent& event)
{
    const QEventPoint& finger = event.points()[0];
    const Pixel at = pixelOf(finger.position());
    if (finger.state() == QEventPoint::Pressed)
        m_start = at;
    const bool lifted = finger.state() == QEventPoint::Released;
    if (!m_pressed && (lifted || (at - m_start).norm() >= QGuiApplication::styleHints()->startDragDistance())) {
        m_pressed = true;
        send(PointerEvent::Kind::Press, m_start, event);
    }
    if (m_pressed)
        send(lifted ? PointerEvent::Kind::Release : PointerEvent::Kind::Move, at, event);
}

/// Zooms by the ratio of the fingers' distances towards their midpoint, then pans with the midpoint. The pan is at the
/// depth of the surface under the midpoint, if known.
void TouchInput::twoFingers(const QTouchEvent& event)
{
    if (m_pressed)
        m_input->finish();
    m_pressed = false;
    const QEventPoint &a = event.points()[0], &b = event.points()[1];
    const Fingers before = m_fingers;
    m_fingers = {a.id(), b.id(), pixelOf(a.position()), pixelOf(b.position())};
    const bool isContinued = m_gesture && before.idA == m_fingers.idA && before.idB == m_fingers.idB;
    m_gesture = true;
    if (!isContinued)
        return m_input->setGestureCenter(0.5 * (m_fingers.a + m_fingers.b));
    const double distance = (before.a - before.b).norm(), newDistance = (m_fingers.a - m_fingers.b).norm();
    const Pixel middle = 0.5 * (before.a + before.b), newMiddle = 0.5 * (m_fingers.a + m_fingers.b);
    if (std::min(distance, newDistance) >= minDistance)
        m_input->zoom(distance / newDistance, middle);
    m_input->pan(newMiddle - middle);
    m_input->setGestureCenter(newMiddle);
}

void TouchInput::send(PointerEvent::Kind kind, const Pixel& pixel, const QTouchEvent& event)
{
    PointerEvent made;
    made.kind = kind;
    made.pixel = pixel;
    made.button = kind == PointerEvent::Kind::Move ? Qt::NoButton : Qt::LeftButton;
    made.modifiers = event.modifiers();
    made.time = static_cast<double>(event.timestamp()) * 1e-3;
    m_input->handle(made);
}
} // namespace ui
