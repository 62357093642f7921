#pragma once

#include "ui/input/pointer_input.h"

class QKeyEvent;

namespace ui
{
/// A pointer for users of the keyboard alone: the arrow keys move it, and it presses as the left button does while
/// Space is held, or from one Return to the next for users who cannot hold a key and press another. On the model that
/// is a stroke, beside it the view turns. No widget. Thread: gui.
class KeyboardCursor : public QObject
{
    Q_OBJECT

public:
    /// The input is not owned.
    explicit KeyboardCursor(PointerInput* input, QObject* parent = nullptr);

    bool isOn() const { return m_isOn; }
    /// At first, and where the view has become smaller, it is brought into the view. Off, it is released.
    void setOn(bool on);

    /// In pixels.
    struct Bounds
    {
        OrbitCamera::Pixel view{1, 1}; ///< its width and height: the cursor stays inside
        double brush = 1;              ///< the brush's radius: a key that is pressed once goes a part of that
    };
    void setBounds(const Bounds& bounds);

    /// False: the key means nothing here.
    bool press(const QKeyEvent& key);
    bool release(const QKeyEvent& key);
    /// Releases the pointer, as at the end of a press, and all keys.
    void releaseAll();

    const OrbitCamera::Pixel& at() const { return m_at; }
    bool isDown() const { return m_isDown; }

Q_SIGNALS:
    /// It is on or off, elsewhere, down or up.
    void changed();

private:
    void step(const QKeyEvent& key);
    void moveTo(const OrbitCamera::Pixel& pixel, const QKeyEvent& key);
    void setDown(bool down, const QKeyEvent& key);
    void send(PointerEvent::Kind kind, const QKeyEvent& key);
    OrbitCamera::Pixel clamped(const OrbitCamera::Pixel& pixel) const;

    PointerInput* m_input;
    bool m_isOn = false, m_isDown = false;
    bool m_isPlaced = false; ///< somewhere, ever
    Bounds m_bounds;
    OrbitCamera::Pixel m_at{0, 0};
    double m_step = 0;   ///< pixels; grows while a key is held
    QList<int> m_arrows; ///< that are held
};
} // namespace ui
