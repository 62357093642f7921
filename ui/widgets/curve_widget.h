#pragma once

#include <QWidget>

namespace ui
{
/// A curve from 0 to 1 over 0 to 1 that is drawn in a frame and bent by dragging, or step by step by the arrow keys.
/// Thread: gui.
class CurveWidget : public QWidget
{
    Q_OBJECT

public:
    explicit CurveWidget(QWidget* parent = nullptr);

    QSize sizeHint() const override { return {200, 96}; }

protected:
    /// y, 0 to 1, at x, 0 to 1.
    virtual double valueAt(double x) const = 0;
    /// So that it passes as near to that place as it can; x and y 0 to 1.
    virtual void bendTo(double x, double y) = 0;
    /// By one step, up (1) or down (-1).
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
