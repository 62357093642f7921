#include "ui/viewport/viewport_state.h"

#include <QMouseEvent>
#include <QNativeGestureEvent>
#include <QTabletEvent>

#include <algorithm>
#include <cmath>

namespace ui
{
namespace
{
constexpr double zoomPerNotch = 0.87;
constexpr double minPinch = 0.1;   ///< of an event: a touchpad that says less means it no more
constexpr double wheelNotch = 120; ///< QWheelEvent's eighths of a degree

OrbitCamera::Pixel pixelOf(const QPointF& position)
{
    return {position.x(), position.y()};
}

PointerEvent pointerEvent(PointerEvent::Kind kind, const QSinglePointEvent& event)
{
    PointerEvent made;
    made.kind = kind;
    made.pixel = pixelOf(event.position());
    made.button = event.button();
    made.modifiers = event.modifiers();
    made.time = static_cast<double>(event.timestamp()) * 1e-3;
    return made;
}

/// A touchpad's fingers, where the system tells pinching from scrolling, which comes as a wheel. False: it means
/// nothing to us.
bool handleGesture(PointerInput& input, const QNativeGestureEvent& event)
{
    switch (event.gestureType()) {
    case Qt::ZoomNativeGesture:
        input.zoom(1 / std::max(1 + event.value(), minPinch), pixelOf(event.position()));
        return true;
    case Qt::PanNativeGesture:
        input.pan(pixelOf(event.delta()));
        return true;
    default:
        return false;
    }
}
} // namespace

void Viewport::changeEvent(QEvent* event)
{
    QOpenGLWidget::changeEvent(event);
    if (event->type() != QEvent::PaletteChange)
        return;
    updateCursor(); // it may be a drawing in the text's colour
    update();
}

/// Ignores the mouse while the keyboard cursor is down.
void Viewport::mousePressEvent(QMouseEvent* event)
{
    if (m_state->keyboardCursor.isDown())
        return;
    m_state->flight.stop();
    m_state->input.handle(pointerEvent(PointerEvent::Kind::Press, *event));
}

void Viewport::mouseMoveEvent(QMouseEvent* event)
{
    if (m_state->keyboardCursor.isDown())
        return;
    restartPointingTimer();
    m_state->input.handle(pointerEvent(PointerEvent::Kind::Move, *event));
}

void Viewport::mouseReleaseEvent(QMouseEvent* event)
{
    if (m_state->keyboardCursor.isDown())
        return;
    m_state->input.handle(pointerEvent(PointerEvent::Kind::Release, *event));
}

/// Accepted, or Qt would send the same again as a mouse's.
void Viewport::tabletEvent(QTabletEvent* event)
{
    const auto kind = event->type() == QEvent::TabletPress     ? PointerEvent::Kind::Press
                      : event->type() == QEvent::TabletRelease ? PointerEvent::Kind::Release
                                                               : PointerEvent::Kind::Move;
    restartPointingTimer();
    PointerEvent pen = pointerEvent(kind, *event);
    pen.pressure = event->pressure();
    pen.isEraser = event->pointerType() == QPointingDevice::PointerType::Eraser;
    m_state->input.handle(pen);
    event->accept();
}

void Viewport::wheelEvent(QWheelEvent* event)
{
    m_state->flight.stop();
    const double notches = event->angleDelta().y() / wheelNotch;
    if (notches != 0)
        m_state->input.zoom(std::pow(zoomPerNotch, notches), pixelOf(event->position()));
    event->accept();
}

void Viewport::leaveEvent(QEvent* event)
{
    if (!hasKeyboardCursor())
        m_state->input.pointerLeft();
    QOpenGLWidget::leaveEvent(event);
}

/// Qt has no handler for fingers alone. A dialog that opens over us, or a view that vanishes, swallows the release.
bool Viewport::event(QEvent* event)
{
    switch (event->type()) {
    case QEvent::TouchBegin:
    case QEvent::TouchUpdate:
    case QEvent::TouchEnd:
    case QEvent::TouchCancel:
        m_state->touch.handle(*static_cast<QTouchEvent*>(event));
        event->accept(); // or Qt would send the same again as a mouse's
        return true;
    case QEvent::NativeGesture:
        if (handleGesture(m_state->input, *static_cast<QNativeGestureEvent*>(event)))
            return true;
        break;
    case QEvent::WindowBlocked:
    case QEvent::Hide:
        finish();
        break;
    default:
        break;
    }
    return QOpenGLWidget::event(event);
}

/// Whoever has the focus: the cursor says what a press would do now.
bool Viewport::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::KeyPress || event->type() == QEvent::KeyRelease)
        m_state->input.setModifiers(static_cast<QKeyEvent*>(event)->modifiers());
    if (event->type() == QEvent::KeyPress && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape) {
        setPicking(false);
        setAdding(false);
        setPointing(false);
    }
    return QOpenGLWidget::eventFilter(watched, event);
}
} // namespace ui
