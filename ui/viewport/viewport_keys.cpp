#include "ui/viewport/viewport_state.h"

#include <QKeyEvent>

namespace ui
{
void Viewport::State::reachWithKeys(const QSize& view)
{
    const std::optional<core::SurfaceHit> hit = input.hover();
    const double perMm = camera.pixelsPerMm(hit ? hit->position : camera.pivot());
    keys.setReach({OrbitCamera::Pixel(view.width(), view.height()), perMm * brush->value(core::Parameter::Radius)});
}

void Viewport::prepareKeys()
{
    m_state->cross = new KeyCross(this);
    connect(&m_state->keys, &KeyHand::changed, this, [this] {
        const KeyHand& keys = m_state->keys;
        if (keys.isOn())
            m_state->cross->place(QPointF(keys.at().x(), keys.at().y()), keys.isDown());
        m_state->cross->setVisible(keys.isOn());
    });
}

void Viewport::setKeyHand(bool on)
{
    if (on == hasKeyHand())
        return;
    m_state->reachWithKeys(size());
    m_state->keys.setOn(on);
    if (on)
        setFocus();
    Q_EMIT keyHandChanged(on);
}

bool Viewport::hasKeyHand() const
{
    return m_state->keys.isOn();
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
    m_state->input.zoom(factor,
                        hasKeyHand() ? m_state->keys.at() : OrbitCamera::Pixel(0.5 * m_state->camera.viewport()));
}

void Viewport::keyPressEvent(QKeyEvent* event)
{
    m_state->reachWithKeys(size());
    if (!m_state->keys.press(*event))
        QOpenGLWidget::keyPressEvent(event);
}

void Viewport::keyReleaseEvent(QKeyEvent* event)
{
    if (!m_state->keys.release(*event))
        QOpenGLWidget::keyReleaseEvent(event);
}

/// Whoever has the focus gets the keys: what is held would never be let go.
void Viewport::focusOutEvent(QFocusEvent* event)
{
    m_state->keys.lift();
    QOpenGLWidget::focusOutEvent(event);
}
} // namespace ui
