#pragma once

#include "ui/headset/simulator_controls.h"

#include <QImage>
#include <QSet>
#include <QWidget>

#include <initializer_list>

namespace ui
{
/// Shows what the simulated headset shows, and controls it: mouse and keys move the simulated user's head and wands.
/// Thread: gui.
class SimulatorView : public QWidget
{
    Q_OBJECT

public:
    explicit SimulatorView(QWidget* parent = nullptr);

    const SimulatorControls& controls() const { return m_controls; }
    /// Takes what is under the mouse, as SimulatorControls::meet() has it.
    void meet(const std::optional<SimulatorControls::Surface>& surface, SimulatorControls::Following following,
              bool isRay)
    {
        m_controls.meet(surface, following, isRay);
    }
    /// A new one, with nothing pressed, and nothing to see yet.
    void begin();
    void setPicture(const QImage& picture);
    /// Turns the head as SimulatorControls::turnHead() does.
    void turnHead(double left, double up) { m_controls.turnHead(left, up); }
    /// Gives the mouse to the other hand. The hand before goes on squeezing, as both do that stretch the model; else it
    /// lets go.
    void changeHand();
    /// So much time has passed: keys that are down walk.
    void advance(double seconds);

    /// Where a place of the picture, -1 to 1 right and up, is in this widget.
    QPointF placeOf(const Eigen::Vector2d& place) const;
    const QImage& picture() const { return m_picture; }
    QSize sizeHint() const override { return {810, 720}; }
    QSize minimumSizeHint() const override { return {360, 320}; }

Q_SIGNALS:
    /// Buttons of a wand are pressed or released.
    void buttonsChanged();
    /// Another hand follows the mouse.
    void handChanged();
    /// The mouse has turned the head.
    void headTurned();
    void escaped();

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void keyReleaseEvent(QKeyEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    bool focusNextPrevChild(bool) override { return false; } // Tab is a key here

private:
    /// Of the hand that follows the mouse.
    SimulatedButtons& buttons() { return m_controls.buttons(m_controls.hand()); }
    QRectF frame() const;
    bool press(const QKeyEvent& event, bool isDown);
    bool pressPad(int key, bool isDown);
    void squeeze(std::initializer_list<SimulatedHand> hands, bool isDown);
    void pressTrigger(bool isDown, Qt::KeyboardModifiers modifiers);
    void slide(const QPointF& by);

    SimulatorControls m_controls;
    QImage m_picture;
    QSet<int> m_walking; ///< keys that are down
    QPointF m_mouse;     ///< where it was last
};
} // namespace ui
