#include "ui/viewport/keyboard_cursor.h"

#include <QKeyEvent>

#include <algorithm>
#include <cmath>
#include <utility>

namespace ui
{
namespace
{
constexpr double firstStep = 0.125, maxStep = 0.5; ///< distance of a key press in radii of the brush
constexpr double minStep = 1;                      ///< smallest distance of a key press, pixels
constexpr double growth = 1.25;                    ///< factor on the distance at each repetition of a held key
/// pixels between the samples that a longer step is divided into, as a mouse would deliver
constexpr double sampleStep = 4;

OrbitCamera::Pixel directionOf(int key)
{
    switch (key) {
    case Qt::Key_Left:
        return {-1, 0};
    case Qt::Key_Right:
        return {1, 0};
    case Qt::Key_Up:
        return {0, -1};
    case Qt::Key_Down:
        return {0, 1};
    default:
        return {0, 0};
    }
}

bool isArrow(int key)
{
    return directionOf(key) != OrbitCamera::Pixel(0, 0);
}
} // namespace

KeyboardCursor::KeyboardCursor(PointerInput* input, QObject* parent) : QObject(parent), m_input(input) {}

void KeyboardCursor::setOn(bool on)
{
    if (std::exchange(m_isOn, on) == on)
        return;
    if (on) {
        m_at = clamped(m_isPlaced ? m_at : OrbitCamera::Pixel(0.5 * m_bounds.view));
        m_isPlaced = true;
        m_input->handle({.kind = PointerEvent::Kind::Move, .pixel = m_at, .modifiers = {}});
    } else {
        releaseAll();
        m_input->pointerLeft();
    }
    Q_EMIT changed();
}

void KeyboardCursor::setBounds(const Bounds& bounds)
{
    m_bounds = bounds;
    if (const OrbitCamera::Pixel to = clamped(m_at); m_isOn && to != m_at) {
        m_at = to;
        Q_EMIT changed();
    }
}

bool KeyboardCursor::press(const QKeyEvent& key)
{
    if (!m_isOn)
        return false;
    if (isArrow(key.key())) {
        step(key);
        return true;
    }
    const bool isSpace = key.key() == Qt::Key_Space,
               isReturn = key.key() == Qt::Key_Return || key.key() == Qt::Key_Enter;
    if (!isSpace && !isReturn)
        return false;
    if (!key.isAutoRepeat())
        setDown(isSpace || !m_isDown, key);
    return true;
}

bool KeyboardCursor::release(const QKeyEvent& key)
{
    if (!m_isOn || key.isAutoRepeat())
        return m_isOn && (isArrow(key.key()) || key.key() == Qt::Key_Space);
    if (m_arrows.removeAll(key.key()) > 0)
        return true;
    if (key.key() != Qt::Key_Space)
        return false;
    setDown(false, key);
    return true;
}

void KeyboardCursor::releaseAll()
{
    m_arrows.clear();
    if (!std::exchange(m_isDown, false))
        return;
    m_input->finish();
    Q_EMIT changed();
}

/// Moves the cursor by one key press. Two arrow keys held together move it diagonally.
void KeyboardCursor::step(const QKeyEvent& key)
{
    const double first = std::max(minStep, firstStep * m_bounds.brush);
    m_step = key.isAutoRepeat() ? std::min(m_step * growth, std::max(first, maxStep * m_bounds.brush)) : first;
    if (!m_arrows.contains(key.key()))
        m_arrows << key.key();
    OrbitCamera::Pixel way(0, 0);
    for (const int arrow : m_arrows)
        way += directionOf(arrow);
    const OrbitCamera::Pixel from = m_at, to = clamped(m_at + m_step * way);
    const int samples = std::max(1, static_cast<int>(std::ceil((to - from).norm() / sampleStep)));
    for (int i = 1; i <= samples; ++i)
        moveTo(from + (to - from) * i / samples, key);
    Q_EMIT changed();
}

void KeyboardCursor::moveTo(const OrbitCamera::Pixel& pixel, const QKeyEvent& key)
{
    m_at = pixel;
    send(PointerEvent::Kind::Move, key);
}

void KeyboardCursor::setDown(bool down, const QKeyEvent& key)
{
    if (std::exchange(m_isDown, down) == down)
        return;
    send(down ? PointerEvent::Kind::Press : PointerEvent::Kind::Release, key);
    Q_EMIT changed();
}

void KeyboardCursor::send(PointerEvent::Kind kind, const QKeyEvent& key)
{
    PointerEvent event;
    event.kind = kind;
    event.pixel = m_at;
    event.button = kind == PointerEvent::Kind::Move ? Qt::NoButton : Qt::LeftButton;
    event.modifiers = key.modifiers() & ~Qt::KeyboardModifiers(Qt::KeypadModifier);
    event.time = static_cast<double>(key.timestamp()) * 1e-3;
    m_input->handle(event);
}

OrbitCamera::Pixel KeyboardCursor::clamped(const OrbitCamera::Pixel& pixel) const
{
    return pixel.cwiseMin(m_bounds.view - OrbitCamera::Pixel(1, 1)).cwiseMax(0);
}
} // namespace ui
