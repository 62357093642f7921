#pragma once

#include <QWidget>

namespace ui
{
/// A cross at the keyboard cursor's position; drawn over its parent and transparent for the mouse.
class KeyboardCursorOverlay : public QWidget
{
    Q_OBJECT

public:
    explicit KeyboardCursorOverlay(QWidget* parent);

    /// Moves the cross to `at` in the parent's pixels. `down`: draw it as pressed.
    void place(const QPointF& at, bool down);

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    bool m_isDown = false;
};
} // namespace ui
