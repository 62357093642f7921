#pragma once

#include <QPointF>
#include <QTimer>
#include <QWidget>

#include <optional>

namespace ui
{
/// Highlights the place that a user points at: a bright spot with a ring that spreads, over its parent, transparent for
/// the mouse.
class PointerHighlight : public QWidget
{
    Q_OBJECT

public:
    explicit PointerHighlight(QWidget* parent);

    /// Of its middle, in the parent's pixels; nothing: it is hidden.
    void place(const std::optional<QPointF>& middle);
    /// The ring stands still.
    void setReducesMotion(bool reducesMotion);

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    double m_pulse = 0; ///< 0 to 1: how far the ring has come
    bool m_reducesMotion = false;
    QTimer m_timer;
};
} // namespace ui
