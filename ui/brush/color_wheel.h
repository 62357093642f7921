#pragma once

#include "core/geometry/geometry.h"

#include <QWidget>

namespace ui
{
/// Hue on a ring, saturation (to the right) and value (upwards) in a square within it. Drag either; the arrow keys move
/// in the square, Page Up and Page Down along the ring. A grey keeps the hue that it was made from. Thread: gui.
class ColorWheel : public QWidget
{
    Q_OBJECT

public:
    explicit ColorWheel(QWidget* parent = nullptr);

    core::Rgb color() const;
    /// Without colorChanged().
    void setColor(const core::Rgb& color);

    QSize sizeHint() const override { return {160, 160}; }
    QSize minimumSizeHint() const override { return {144, 144}; }

    /// Where a hue, or a saturation and a value, all 0 to 1, lie in the widget.
    QPointF placeOfHue(double hue) const;
    QPointF placeInSquare(double saturation, double value) const;

Q_SIGNALS:
    /// By hand.
    void colorChanged(const core::Rgb& color);

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    enum class Part { Ring, Square };

    double outerRadius() const;
    QPointF middle() const;
    QRectF square() const;
    void drag(const QPointF& to);
    void set(double hue, double saturation, double value);
    void drawRing(QPainter& painter) const;
    void drawSquare(QPainter& painter) const;
    void drawHandle(QPainter& painter, const QPointF& at, const QColor& inside) const;

    double m_hue = 0, m_saturation = 0, m_value = 0; ///< 0 to 1
    Part m_dragged = Part::Square;
};
} // namespace ui
