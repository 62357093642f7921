#pragma once

#include "brush_settings.h"

#include <QWidget>

namespace ui
{
/// b(x) of the brush (paper, section 3.3) drawn from the centre to the rim; dragging bends it to the n that passes nearest to the
/// hand, the arrow keys step n. The brush must outlive it. Gui thread.
class FalloffCurve : public QWidget
{
    Q_OBJECT

public:
    explicit FalloffCurve(BrushSettings* brush, QWidget* parent = nullptr);

    QSize sizeHint() const override { return {200, 96}; }
    /// The n whose curve passes nearest to a point of the widget.
    int falloffAt(const QPointF& at) const;

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    QRectF plot() const;
    int falloff() const { return m_brush->stroke().falloff; }
    void step(int by);

    BrushSettings* m_brush;
};
} // namespace ui
