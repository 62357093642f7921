#pragma once

#include <QPointF>
#include <QTimer>
#include <QWidget>

#include <optional>

namespace ui
{
/// A light where somebody points: a bright spot with a ring that spreads, over its parent, and the mouse goes through
/// it.
class PointLight : public QWidget
{
    Q_OBJECT

public:
    explicit PointLight(QWidget* parent);

    /// Of its middle, in the parent's pixels; nothing: it is hidden.
    void place(const std::optional<QPointF>& middle);
    /// The ring stands still.
    void setCalm(bool calm);

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    double m_pulse = 0; ///< 0 to 1: how far the ring has come
    bool m_isCalm = false;
    QTimer m_timer;
};
} // namespace ui
