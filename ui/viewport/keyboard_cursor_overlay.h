#pragma once

#include <QWidget>

namespace ui
{
/// Where the hand of the keys is; over its parent, and the mouse goes through it.
class KeyCross : public QWidget
{
    Q_OBJECT

public:
    explicit KeyCross(QWidget* parent);

    /// In the parent's pixels. `down`: it holds the model.
    void place(const QPointF& at, bool down);

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    bool m_isDown = false;
};
} // namespace ui
