#pragma once

#include "ui/headset/simulator_controls.h"

#include <QImage>
#include <QSet>
#include <QWidget>

#include <initializer_list>

namespace ui
{
/// Shows the picture of the simulated headset, and translates mouse and keys into motions of the simulated user's head
/// and wands. Thread: gui.
class SimulatorView : public QWidget
{
    Q_OBJECT

public:
    explicit SimulatorView(QWidget* parent = nullptr);

    const SimulatorControls& controls() const { return m_controls; }
    /// Forwards to SimulatorControls::meet().
    void meet(const std::optional<SimulatorControls::Surface>& surface, SimulatorControls::Following following,
              bool isRay)
    {
        m_controls.meet(surface, following, isRay);
    }
    /// Begins a session: initial pose, no button pressed, no picture.
    void begin();
    void setPicture(const QImage& picture);
    /// Forwards to SimulatorControls::turnHead().
    void turnHead(double left, double up) { m_controls.turnHead(left, up); }
    /// Lets the other hand follow the mouse. The previous hand keeps squeezing, because two-handed stretching needs
    /// both; its other buttons are released.
    void changeHand();
    /// Walks as the pressed keys say, for `seconds`.
    void advance(double seconds);

    /// Returns the widget position of a point of the picture. Units: -1 to 1, right and up.
    QPointF placeOf(const Eigen::Vector2d& place) const;
    const QImage& picture() const { return m_picture; }
    QSize sizeHint() const override { return {810, 720}; }
    QSize minimumSizeHint() const override { return {360, 320}; }

Q_SIGNALS:
    /// A button of a wand was pressed or released.
    void buttonsChanged();
    /// The other hand follows the mouse now.
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
    bool focusNextPrevChild(bool) override { return false; } // Tab is a key of the simulator

private:
    /// Returns the buttons of the hand that follows the mouse.
    SimulatedButtons& buttons() { return m_controls.buttons(m_controls.hand()); }
    QRectF frame() const;
    bool press(const QKeyEvent& event, bool isDown);
    bool pressPad(int key, bool isDown);
    void squeeze(std::initializer_list<SimulatedHand> hands, bool isDown);
    void pressTrigger(bool isDown, Qt::KeyboardModifiers modifiers);
    void slide(const QPointF& by);

    SimulatorControls m_controls;
    QImage m_picture;
    QSet<int> m_walking; ///< pressed walking keys
    QPointF m_mouse;     ///< last position
};
} // namespace ui
