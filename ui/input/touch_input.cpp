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

constexpr double leastApart = 8; ///< logical pixels; fingers that are nearer to each other do not zoom

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
        m_input->leave();
    } else if (event.pointCount() >= 2) {
        twoFingers(event);
    } else if (event.pointCount() == 1 && !m_gesture) {
        oneFinger(event);
    }
    if (event.type() == QEvent::TouchEnd)
        m_input->leave();
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

/// Zooms by the ratio of the fingers' distances, toward the place between them; then follows that place, which is on
/// the surface if that is known there.
void TouchInput::twoFingers(const QTouchEvent& event)
{
    if (m_pressed)
        m_input->finish();
    m_pressed = false;
    const QEventPoint &a = event.points()[0], &b = event.points()[1];
    const Fingers before = m_fingers;
    m_fingers = {a.id(), b.id(), pixelOf(a.position()), pixelOf(b.position())};
    const bool goesOn = m_gesture && before.idA == m_fingers.idA && before.idB == m_fingers.idB;
    m_gesture = true;
    if (!goesOn)
        return m_input->hold(0.5 * (m_fingers.a + m_fingers.b));
    const double apart = (before.a - before.b).norm(), nowApart = (m_fingers.a - m_fingers.b).norm();
    const Pixel middle = 0.5 * (before.a + before.b), nowMiddle = 0.5 * (m_fingers.a + m_fingers.b);
    if (std::min(apart, nowApart) >= leastApart)
        m_input->zoom(apart / nowApart, middle);
    m_input->pan(nowMiddle - middle);
    m_input->hold(nowMiddle);
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
