#pragma once

#include <QWidget>

namespace ui
{
/// Shows where the keyboard cursor is; over its parent, transparent for the mouse.
class KeyboardCursorOverlay : public QWidget
{
    Q_OBJECT

public:
    explicit KeyboardCursorOverlay(QWidget* parent);

    /// In the parent's pixels. `down`: it is pressed.
    void place(const QPointF& at, bool down);

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    bool m_isDown = false;
};
} // namespace ui
