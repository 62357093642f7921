#pragma once

#include "ui/input/pointer_input.h"

class QKeyEvent;

namespace ui
{
/// A pointer for users who have only a keyboard. Arrow keys move it. It acts like the left mouse button while Space is
/// held, or from one Return to the next for users who cannot hold a key while pressing another. On the model this makes
/// a stroke, beside it the view turns. Not a widget. Thread: gui.
class KeyboardCursor : public QObject
{
    Q_OBJECT

public:
    /// The input is not owned.
    explicit KeyboardCursor(PointerInput* input, QObject* parent = nullptr);

    bool isOn() const { return m_isOn; }
    /// Turns the cursor on or off. Turning it on moves it into the view; turning it off releases its button.
    void setOn(bool on);

    /// Sizes that limit and scale the cursor's movement, logical pixels.
    struct Bounds
    {
        OrbitCamera::Pixel view{1, 1}; ///< width and height of the view, which the cursor cannot leave
        double brush = 1;              ///< radius of the brush; a single key press moves by a fraction of it
    };
    void setBounds(const Bounds& bounds);

    /// Handles a key press. Returns false if the key has no meaning for the cursor.
    bool press(const QKeyEvent& key);
    bool release(const QKeyEvent& key);
    /// Releases the cursor's button and all keys.
    void releaseAll();

    const OrbitCamera::Pixel& at() const { return m_at; }
    bool isDown() const { return m_isDown; }

Q_SIGNALS:
    /// The cursor was turned on or off, moved, pressed or released.
    void changed();

private:
    void step(const QKeyEvent& key);
    void moveTo(const OrbitCamera::Pixel& pixel, const QKeyEvent& key);
    void setDown(bool down, const QKeyEvent& key);
    void send(PointerEvent::Kind kind, const QKeyEvent& key);
    OrbitCamera::Pixel clamped(const OrbitCamera::Pixel& pixel) const;

    PointerInput* m_input;
    bool m_isOn = false, m_isDown = false;
    bool m_isPlaced = false; ///< the cursor has been placed in the view at least once
    Bounds m_bounds;
    OrbitCamera::Pixel m_at{0, 0};
    double m_step = 0;   ///< distance per key press, pixels; grows while a key is held
    QList<int> m_arrows; ///< arrow keys that are held
};
} // namespace ui
