#pragma once

#include <QWidget>

namespace ui
{
/// A widget that shows a curve over [0, 1] with values in [0, 1]. Dragging bends the curve, and arrow keys bend it step
/// by step. Thread: gui.
class CurveWidget : public QWidget
{
    Q_OBJECT

public:
    explicit CurveWidget(QWidget* parent = nullptr);

    QSize sizeHint() const override { return {200, 96}; }

protected:
    /// Returns the curve's value, 0 to 1, at x, 0 to 1.
    virtual double valueAt(double x) const = 0;
    /// Bends the curve to pass as near as possible to the point (x, y), 0 to 1 each.
    virtual void bendTo(double x, double y) = 0;
    /// Bends the curve by one step: 1 up, -1 down.
    virtual void step(int by) = 0;

    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    QRectF plot() const;
    void bendTo(const QPointF& at);
};
} // namespace ui
