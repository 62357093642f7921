#pragma once

#include <QPointF>
#include <QTimer>
#include <QWidget>

#include <optional>

namespace ui
{
/// Highlights the place that a user points at: a bright spot with a ring that spreads. Drawn over its parent and
/// transparent for the mouse.
class PointerHighlight : public QWidget
{
    Q_OBJECT

public:
    explicit PointerHighlight(QWidget* parent);

    /// Moves the highlight's centre, in the parent's pixels; nullopt hides it.
    void place(const std::optional<QPointF>& middle);
    /// Stops the ring's animation.
    void setReducesMotion(bool reducesMotion);

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    double m_pulse = 0; ///< progress of the ring's animation, 0 to 1
    bool m_reducesMotion = false;
    QTimer m_timer;
};
} // namespace ui
