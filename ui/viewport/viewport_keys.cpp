#include "ui/viewport/viewport_state.h"

#include <QKeyEvent>

namespace ui
{
void Viewport::State::updateKeyboardCursorBounds(const QSize& view)
{
    const std::optional<core::SurfaceHit> hit = input.hover();
    const double perMm = camera.pixelsPerMm(hit ? hit->position : camera.pivot());
    keyboardCursor.setBounds(
        {OrbitCamera::Pixel(view.width(), view.height()), perMm * brush->value(core::Parameter::Radius)});
}

void Viewport::prepareKeyboardCursor()
{
    m_state->keyboardOverlay = new KeyboardCursorOverlay(this);
    connect(&m_state->keyboardCursor, &KeyboardCursor::changed, this, [this] {
        const KeyboardCursor& keyboardCursor = m_state->keyboardCursor;
        if (keyboardCursor.isOn())
            m_state->keyboardOverlay->place(QPointF(keyboardCursor.at().x(), keyboardCursor.at().y()),
                                            keyboardCursor.isDown());
        m_state->keyboardOverlay->setVisible(keyboardCursor.isOn());
    });
}

void Viewport::setKeyboardCursor(bool on)
{
    if (on == hasKeyboardCursor())
        return;
    m_state->updateKeyboardCursorBounds(size());
    m_state->keyboardCursor.setOn(on);
    if (on)
        setFocus();
    Q_EMIT keyboardCursorChanged(on);
}

bool Viewport::hasKeyboardCursor() const
{
    return m_state->keyboardCursor.isOn();
}

void Viewport::turnView(double right, double down)
{
    m_state->flight.stop();
    const double perDegree = m_state->camera.viewport().y() / 180;
    m_state->input.orbit(perDegree * OrbitCamera::Pixel(right, down));
}

void Viewport::zoomView(double factor)
{
    m_state->flight.stop();
    m_state->input.zoom(factor, hasKeyboardCursor() ? m_state->keyboardCursor.at()
                                                    : OrbitCamera::Pixel(0.5 * m_state->camera.viewport()));
}

void Viewport::keyPressEvent(QKeyEvent* event)
{
    m_state->updateKeyboardCursorBounds(size());
    if (!m_state->keyboardCursor.press(*event))
        QOpenGLWidget::keyPressEvent(event);
}

void Viewport::keyReleaseEvent(QKeyEvent* event)
{
    if (!m_state->keyboardCursor.release(*event))
        QOpenGLWidget::keyReleaseEvent(event);
}

/// Releases all keys: their release events would go to whatever has the focus now.
void Viewport::focusOutEvent(QFocusEvent* event)
{
    m_state->keyboardCursor.releaseAll();
    QOpenGLWidget::focusOutEvent(event);
}
} // namespace ui
